// normal_map, lists of normals and average.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <0.9, 0.75, 0.5> } finish { phong 0.5 } }
sphere { 0, 0.95 normal { gradient x normal_map { [0.2 bumps 0.7 scale 0.1] [0.8 granite 0.4 scale 0.5] } scale 0.7 } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 normal { checker normal { bumps 0.8 scale 0.1 } normal { gradient x 0.6 scale 0.1 } scale 0.4 } translate <0, 1.15, 0> }
sphere { 0, 0.95 normal { average normal_map { [1 bumps 0.5 scale 0.2] [2 ripples 0.8 scale 0.3] [0.5 bozo 0.7 scale 0.1] } } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 normal { gradient z normal_map { [0.1 bozo 1 scale 0.2] [0.9 quilted 1 scale 0.3] } scale <0.5, 1, 0.7> rotate 20*y } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 normal { hexagon normal { wrinkles 0.8 scale 0.2 } normal { bumps 0 } normal { dents 1.5 scale 0.1 } scale 0.3 } translate <0, -1.15, 0> }
sphere { 0, 0.95 normal { bozo normal_map { [0.4 onion 0.6 scale 0.1 sine_wave] [0.6 marble 0.5 turbulence 0.5 scale 0.2] } scale 0.5 } translate <2.3, -1.15, 0> }
