// tiles and material_map.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
sphere { 0, 0.95 texture { tiles { texture { pigment { rgb <1, 0.6, 0.3> } } tile2 texture { pigment { bozo scale 0.1 } finish { phong 1 } } } scale 0.4 } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 texture { material_map { png "pal.png" texture { pigment { rgb x } } texture { pigment { rgb y } normal { bumps 1 scale 0.1 } } texture { pigment { checker scale 0.1 } } } scale 1.9 translate -0.95 } translate <0, 1.15, 0> }
sphere { 0, 0.95 texture { material_map { ppm "a.ppm" map_type 1 texture { pigment { rgb <1, 0.5, 0> } } texture { pigment { wood scale 0.2 } } texture { pigment { rgb 1 } finish { reflection 0.5 } } } } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 texture { material_map { png "pal.png" once texture { pigment { rgb 1 } } texture { pigment { rgb <0, 0.5, 1> } } } translate -0.5 } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 texture { tiles { texture { pigment { rgb 1 } } texture { pigment { gradient y color_map { [0.5 rgbt 1] [0.5 rgb <0.5, 0, 0>] } scale 0.1 } } tile2 texture { pigment { rgb 0.2 } } } scale 0.5 rotate 30*z } translate <0, -1.15, 0> }
sphere { 0, 0.95 texture { material_map { png "pal.png" interpolate 2 texture { pigment { rgb x } } texture { pigment { rgb y } } texture { pigment { rgb z } } } scale 0.7 } translate <2.3, -1.15, 0> }
