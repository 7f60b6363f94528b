// ripples: frequency and phase.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <0.85, 0.8, 0.7> } finish { phong 0.4 phong_size 30 } }
sphere { 0, 0.95 normal { ripples 0.5 } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 normal { ripples 0.6 frequency 3 phase 0.2 scale 0.5 } translate <0, 1.15, 0> }
sphere { 0, 0.95 normal { ripples 0.8 scale 0.2 turbulence 0.3 } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 normal { ripples 0.5 frequency 8 scale <1, 0.3, 1> } translate <-2.3, -1.15, 0> }
