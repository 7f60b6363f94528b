// Finishes that change from place to place: both neighbours are shaded whole and mixed.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
sphere { <-1, 0.6, 0>, 0.6 texture { gradient y texture_map { [0.2 pigment { rgb <0.8, 0.2, 0.2> } finish { reflection 0.6 diffuse 0.2 }] [0.8 pigment { rgb <0.2, 0.3, 0.8> } finish { specular 1 roughness 0.005 }] } scale 1.2 } }
sphere { <0.4, 0.6, 0>, 0.6 texture { average texture_map { [1 pigment { rgbt <1, 0.5, 0.5, 0.9> }] [2 pigment { rgb <0.3, 0.8, 0.4> } finish { phong 1 }] } } }
box { <1.2, 0, -0.4>, <2.1, 1, 0.5> texture { checker texture { pigment { rgb 1 } finish { reflection 0.7 diffuse 0.1 } } texture { pigment { rgb <0.6, 0.4, 0.1> } } scale 0.3 } }
