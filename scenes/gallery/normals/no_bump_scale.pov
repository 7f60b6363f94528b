// no_bump_scale: the depth stays under scaling.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <0.85, 0.8, 0.7> } finish { phong 0.4 phong_size 30 } }
sphere { 0, 0.95 normal { bumps 0.3 scale 0.1 } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 normal { bumps 0.3 scale 0.1 no_bump_scale } translate <0, 1.15, 0> }
sphere { 0, 0.95 normal { granite 0.1 scale 0.2 no_bump_scale } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 normal { bozo 0.3 scale <0.1, 0.5, 0.2> no_bump_scale rotate 30*z } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 normal { bumps 0.3 no_bump_scale scale 5 } translate <0, -1.15, 0> }
sphere { 0, 0.95 normal { gradient x normal_map { [0.3 bumps 0.2 scale 0.3] [0.7 bozo 0.1 scale 0.3] } scale 0.5 no_bump_scale } translate <2.3, -1.15, 0> }
