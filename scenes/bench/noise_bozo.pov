// A plane of bozo: what one noise per pixel costs.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0.6, 0> }
light_source { <10, 20, -15> rgb 1 }
plane { y, 0 pigment { bozo color_map { [0.3 rgb <0.1, 0.2, 0.5>] [0.7 rgb 1] } scale 0.4 } }
