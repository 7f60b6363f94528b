// A plane of crackle: the nearest of random points.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0.6, 0> }
light_source { <10, 20, -15> rgb 1 }
plane { y, 0 pigment { crackle color_map { [0 rgb 0] [0.3 rgb <0.9, 0.7, 0.4>] } scale 0.5 } }
