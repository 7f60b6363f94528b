// Bumps on smooth triangles, inside a CSG and seen in mirrors and glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <0.85, 0.8, 0.7> } finish { phong 0.4 phong_size 30 } }
#declare Bumps = normal { bumps 0.6 scale 0.15 }
smooth_triangle { <-1, -1, 0>, <-0.5, -0.3, -1>, <1, -1, 0>, <0.5, -0.3, -1>, <0, 1, 0>, <0, 0.6, -1> normal { ripples 0.4 frequency 4 } translate <-2.3, 1.1, 0> }
difference { sphere { 0, 1 normal { Bumps } } box { <0, -1, -2>, <2, 2, 0.2> normal { wrinkles 0.7 scale 0.2 } } rotate 20*y translate <0, 1.1, 0> }
sphere { 0, 0.95 pigment { rgb 0.1 } normal { Bumps } finish { reflection 0.8 } translate <2.3, 1.1, 0> }
sphere { 0, 0.95 pigment { rgbf <0.9, 1, 0.9, 0.9> } normal { bumps 0.3 scale 0.3 } interior { ior 1.4 } translate <-1.3, -1.2, 0> }
union { sphere { -x * 0.5, 0.6 } sphere { x * 0.5, 0.6 normal { dents 1 scale 0.1 } } normal { Bumps } translate <1.3, -1.2, 0> }
plane { y, -2.3 pigment { checker rgb 0.9, rgb 0.4 } normal { bumps 0.2 scale 0.3 } }
