// Wave forms shape the heights of gradient.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <0.85, 0.8, 0.7> } finish { phong 0.4 phong_size 30 } }
sphere { 0, 0.95 normal { gradient x 0.6 ramp_wave scale 0.3 } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 normal { gradient x 0.6 sine_wave scale 0.3 } translate <0, 1.15, 0> }
sphere { 0, 0.95 normal { gradient x 0.6 triangle_wave scale 0.3 } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 normal { gradient x 0.6 scallop_wave scale 0.3 } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 normal { gradient x 0.6 cubic_wave scale 0.3 } translate <0, -1.15, 0> }
sphere { 0, 0.95 normal { gradient x 0.6 poly_wave 3 frequency 2 scale 0.3 } translate <2.3, -1.15, 0> }
