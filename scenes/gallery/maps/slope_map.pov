// slope_map: heights and slopes make profiles.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <0.9, 0.75, 0.5> } finish { phong 0.5 } }
sphere { 0, 0.95 normal { gradient x 0.8 slope_map { [0 <0, 1>] [0.5 <1, 0>] [1 <0, -1>] } scale 0.3 } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 normal { bozo 0.8 slope_map { [0.3 <0, 0>] [0.4 <0.2, 1>] [0.4 <0.5, 0>] [0.9 <1, -1>] } scale 0.3 } translate <0, 1.15, 0> }
sphere { 0, 0.95 normal { wood 0.6 slope_map { [0 <0, 0>] [0.5 <1, 0>] [0.5 <1, 0>] [1 <0, 0>] } scale 0.3 } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 normal { radial 0.5 frequency 8 slope_map { [0 <0, 0.5>] [0.3 <0.5, 0>] [1 <1, 1>] } } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 normal { gradient y 1 slope_map { [0.5 <1, 1>] [0.7 <0, 0>] } triangle_wave scale 0.4 } translate <0, -1.15, 0> }
sphere { 0, 0.95 normal { crackle 0.7 slope_map { [0 <0, 1>] [0.2 <0.8, 0>] } scale 0.3 } translate <2.3, -1.15, 0> }
