// What slope sees: bumps of its layer, under patterned textures, without bump scaling.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#declare S = color_map { [0.2 rgb <0.2, 0.1, 0.4>] [0.6 rgb <0.9, 0.6, 0.2>] [0.9 rgb 1] }
#declare P = texture { pigment { slope x color_map { S } } normal { bumps 0.5 scale 0.3 } finish { ambient 0.5 } }
sphere { 0, 0.95 texture { pigment { slope y color_map { S } } normal { bumps 0.6 scale 0.2 } } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 texture { gradient x texture_map { [0.2 P] [0.8 gradient y texture_map { [0.3 P] [0.7 P] } scale <0.2, 1, 1>] } scale 2 translate 1 } translate <0, 1.15, 0> }
sphere { 0, 0.95 texture { pigment { aoi color_map { S } } normal { bumps 0.6 scale 0.2 no_bump_scale } } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 texture { pigment { rgb 1 } normal { bumps 1 scale 0.1 } } texture { pigment { slope y color_map { [0.4 rgb <0.2, 0.4, 0.9>] [0.6 rgbt 1] } } } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 texture { slope y texture_map { [0.4 pigment { rgb <0.3, 0.5, 0.2> }] [0.7 pigment { rgb 1 } normal { bumps 0.5 scale 0.1 }] } } translate <0, -1.15, 0> }
sphere { 0, 0.95 texture { pigment { slope { y, 0.2, 0.9 altitude y, -1, 1 } color_map { S } } normal { wrinkles 0.5 scale 0.3 } } translate <2.3, -1.15, 0> }
