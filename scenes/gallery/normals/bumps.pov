// bumps: amount, scale, turbulence; slope_map and waves have no effect.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <0.85, 0.8, 0.7> } finish { phong 0.4 phong_size 30 } }
sphere { 0, 0.95 normal { bumps } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 normal { bumps 0.8 scale 0.2 } translate <0, 1.15, 0> }
sphere { 0, 0.95 normal { bumps -1 scale 0.1 } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 normal { bumps 0.6 turbulence 0.5 scale 0.2 } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 normal { bumps 0.7 sine_wave frequency 3 slope_map { [0 <0, 1>] [1 <1, 0>] } scale 0.2 } translate <0, -1.15, 0> }
sphere { 0, 0.95 normal { bumps, 1 scale <0.1, 0.5, 0.3> rotate 40*z } translate <2.3, -1.15, 0> }
