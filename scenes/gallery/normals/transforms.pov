// Stretched, sheared and mirrored bumps; transforms of the object.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <0.85, 0.8, 0.7> } finish { phong 0.4 phong_size 30 } }
sphere { 0, 0.95 normal { gradient x 0.5 sine_wave scale 0.2 rotate 45*z } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 normal { bumps 0.7 scale <0.05, 0.4, 0.2> } translate <0, 1.15, 0> }
sphere { 0, 0.95 normal { bumps 0.7 matrix <1, 0.5, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0> scale 0.2 } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 normal { onion 0.6 sine_wave scale <-0.2, 0.1, 0.2> translate 0.3 } scale <1, 0.6, 1> rotate 30*z normal { bumps 0 } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 normal { bumps 0.6 warp { repeat 0.5*x flip x } scale 0.3 } translate <0, -1.15, 0> }
sphere { 0, 0.95 normal { bozo 0.6 warp { spherical } scale 0.3 } translate <2.3, -1.15, 0> }
