// no_bump_scale in textures: before and after the normal, handed down to entries.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#declare A = texture { pigment { rgb <1, 0.8, 0.6> } normal { bumps 0.3 scale 0.3 } }
#declare L = texture { pigment { rgb 1 } normal { bumps 0.3 scale 0.5 } } texture { pigment { rgbt <0.5, 0.7, 1, 0.5> } normal { ripples 0.3 scale 0.5 } finish { phong 1 } }
sphere { 0, 0.95 texture { pigment { rgb 1 } normal { bumps 0.2 scale 0.1 } no_bump_scale } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 texture { no_bump_scale pigment { rgb 1 } normal { bumps 0.2 scale 0.1 } } translate <0, 1.15, 0> }
sphere { 0, 0.95 texture { pigment { rgb 1 } normal { bumps 0.2 } no_bump_scale scale 0.1 } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 texture { checker texture { A } texture { A rotate 90*z } scale 0.3 no_bump_scale } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 texture { L no_bump_scale scale 0.3 } translate <0, -1.15, 0> }
sphere { 0, 0.95 texture { pigment { rgb 1 } normal { gradient x normal_map { [0.4 bumps 0.1 scale 0.2] [0.6 bozo 0.1 scale 0.2] } } no_bump_scale } translate <2.3, -1.15, 0> }
