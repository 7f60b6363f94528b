// double_illuminate: thin surfaces show the light of their other side.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
disc { <-1.2, 1, 0>, <0.3, 0, -1>, 0.7 pigment { rgb <0.9, 0.7, 0.3> } finish { phong 0.5 } double_illuminate }
disc { <0.4, 1, 0>, <0.3, 0, -1>, 0.7 pigment { rgb <0.9, 0.7, 0.3> } finish { phong 0.5 } }
sphere { <1.8, 0.5, 0>, 0.5 hollow pigment { rgbt <0.5, 0.8, 0.9, 0.4> } double_illuminate }
light_source { <2, 3, 5> rgb 0.9 }
