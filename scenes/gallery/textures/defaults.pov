// #default: pigment, normal, finish and whole textures; what map entries start from.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <1, 0.8, 0.5> } }
#default { normal { bumps 0.6 scale 0.2 } finish { phong 0.7 ambient 0.2 } }
#default { pigment { gradient y color_map { [0 rgb <0.6, 0.2, 0>] [1 rgb <1, 0.9, 0.6>] } } }
sphere { 0, 0.95  translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 pigment { bozo scale 0.2 } translate <0, 1.15, 0> }
sphere { 0, 0.95 normal { granite 0.2 } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 texture { gradient y texture_map { [0.3 normal { bumps 0 }] [0.7 pigment { rgb <0.3, 0.6, 1> }] } } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 pigment { checker pigment { } pigment { rgb 0.3 } scale 0.3 } translate <0, -1.15, 0> }
sphere { 0, 0.95 texture { } translate <2.3, -1.15, 0> }
