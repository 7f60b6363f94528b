// Shapes as heights: boxed, spherical, cylindrical, planar, onion, leopard.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <0.85, 0.8, 0.7> } finish { phong 0.4 phong_size 30 } }
sphere { 0, 0.95 normal { boxed 1 frequency 3 } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 normal { spherical 1 frequency 4 triangle_wave } translate <0, 1.15, 0> }
sphere { 0, 0.95 normal { cylindrical 1 frequency 3 sine_wave } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 normal { planar 1 frequency 3 scallop_wave } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 normal { onion 0.8 sine_wave scale 0.2 } translate <0, -1.15, 0> }
sphere { 0, 0.95 normal { leopard 0.8 scale 0.05 } translate <2.3, -1.15, 0> }
