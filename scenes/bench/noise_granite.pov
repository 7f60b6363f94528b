// A plane of granite: six noises per pixel.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0.6, 0> }
light_source { <10, 20, -15> rgb 1 }
plane { y, 0 pigment { granite color_map { [0 rgb <0.2, 0.15, 0.1>] [0.5 rgb <0.9, 0.85, 0.8>] } scale 0.8 } }
