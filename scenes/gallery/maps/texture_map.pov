// texture_map: whole textures blend, each with its finish and bumps.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#declare Inner = texture { granite texture_map { [0.2 pigment { rgb 1 }] [0.4 pigment { rgb <0.1, 0.4, 0.2> } finish { phong 1 }] } scale 0.5 }
sphere { 0, 0.95 texture { gradient x texture_map { [0.3 pigment { rgb <1, 0.3, 0.1> } finish { phong 1 }] [0.7 pigment { rgb <0.2, 0.4, 1> } finish { reflection 0.5 }] } translate 0.5 } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 texture { checker texture { pigment { bozo scale 0.1 } } texture { pigment { rgb 1 } normal { bumps 1 scale 0.1 } } scale 0.4 } translate <0, 1.15, 0> }
sphere { 0, 0.95 texture { bozo texture_map { [0.4 pigment { rgbt <1, 1, 1, 0.8> }] [0.6 pigment { rgb <0.8, 0.6, 0.2> } finish { specular 0.8 metallic }] } turbulence 0.3 scale 0.4 } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 texture { spherical texture_map { [0.05 pigment { wood scale 0.1 }] [0.1 Inner] } frequency 3 } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 texture { average texture_map { [1 pigment { rgb <1, 0, 0> } finish { ambient 0.5 }] [2 pigment { gradient y scale 0.3 } normal { ripples 0.5 scale 0.2 }] } } translate <0, -1.15, 0> }
sphere { 0, 0.95 texture { brick texture { pigment { rgb 0.8 } } texture { pigment { rgb <0.6, 0.1, 0.1> } normal { granite 0.3 } } scale 0.1 } translate <2.3, -1.15, 0> }
