// Before language 3.5 a camera{} does not start from that of #default.
#version 3.1;
global_settings { assumed_gamma 1 }
#default { camera { location <3, 4, -2> right x angle 20 look_at 0 } }
camera { location <0, 1, -5> }
light_source { <-4, 8, -10> rgb 1 }
plane { y, -1 pigment { checker rgb 1, rgb <0.3, 0.4, 0.6> } }
sphere { 0, 1 pigment { gradient y color_map { [0 rgb <0.8, 0.2, 0.1>] [1 rgb <1, 0.9, 0.3>] } } }
