// Bumps bend the light, too: the normal of the top layer counts.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
sphere { <-1, 0.7, 0>, 0.7 texture { pigment { rgbt <1, 1, 1, 0.9> } normal { ripples 0.6 scale 0.3 } } texture { pigment { rgbt <0.8, 0.9, 1, 0.9> } normal { bumps 0.8 scale 0.3 } } interior { ior 1.3 } }
box { <0.4, 0.1, -0.5>, <1.6, 1.2, 0.2> pigment { rgbf <0.9, 1, 1, 0.9> } normal { dents 1.5 scale 0.2 } interior { ior 1.4 } rotate 15*y }
