// pigment_pattern of pigments that look at the surface: slope, aoi and uv_mapping within it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -9> look_at 0 angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
#declare Grey = color_map { [0 rgb 0] [1 rgb 1] }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
#default { finish { ambient 0.4 } }
sphere { 0, 0.95 pigment { pigment_pattern { slope y color_map { Grey } } color_map { Ramp } } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 pigment { pigment_pattern { aoi color_map { Grey } } frequency 2 color_map { Ramp } } translate <0, 1.15, 0> }
torus { 0.65, 0.3 rotate -60*x pigment { pigment_pattern { pigment_pattern { slope <1, 1, 0> color_map { Grey } } color_map { Grey } frequency 3 } color_map { Ramp } } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 pigment { rgb 0.9 } normal { pigment_pattern { dents scale 0.4 pigment_map { [0 slope y color_map { Grey }] [1 rgb 0.2] } } 2 } translate <-2.3, -1.15, 0> }
torus { 0.65, 0.3 rotate -60*x texture { pigment_pattern { aoi color_map { Grey } } texture_map { [0.5 pigment { rgb x } normal { bumps 0.5 scale 0.1 }] [0.8 pigment { rgb z } finish { phong 1 }] } } translate <0, -1.15, 0> }
sphere { 0, 0.95 pigment { pigment_pattern { uv_mapping checker rgb 0.2 rgb 0.8 scale 0.1 } color_map { Ramp } } translate <2.3, -1.15, 0> }
