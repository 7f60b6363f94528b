// Patterned textures inside each other; transforms of the outer ones bend the normals inside.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#declare A = texture { pigment { rgb <1, 0.8, 0.5> } normal { bumps 0.7 scale 0.2 } finish { phong 0.6 } }
#declare B = texture { pigment { gradient x color_map { [0 rgb <0.3, 0.5, 1>] [1 rgb 1] } scale 0.2 } normal { gradient y 0.8 sine_wave scale 0.2 } }
sphere { 0, 0.95 texture { checker texture { A } texture { B } scale <0.2, 0.5, 0.3> rotate 30*z } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 texture { gradient x texture_map { [0.3 A scale 0.3] [0.7 B rotate 40*z] } scale <0.3, 1, 1> } translate <0, 1.15, 0> }
sphere { 0, 0.95 texture { gradient x texture_map { [0.2 B] [0.8 gradient y texture_map { [0.3 A] [0.7 B] } scale <0.2, 1, 1>] } scale 2 translate 1 } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 texture { average texture_map { [1 gradient z texture_map { [0.3 A] [0.7 B] } scale <1, 0.2, 1>] [1 B] } } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 texture { bozo texture_map { [0.4 A] [0.6 wood texture_map { [0.4 A] [0.6 B] } scale 0.2 rotate 30*x] } scale 0.5 } translate <0, -1.15, 0> }
sphere { 0, 0.95 texture { spherical texture_map { [0 A] [0.5 B] } scale <1.5, 0.7, 1> no_bump_scale } translate <2.3, -1.15, 0> }
