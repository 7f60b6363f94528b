// no_image and no_reflection: through glass, in a mirror, in a mirror behind glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
box { <-3, 0, 1.5>, <3, 2.4, 1.6> pigment { rgb 0.1 } finish { reflection 0.8 } }
sphere { <-1.8, 0.4, 0.3>, 0.4 pigment { rgb <0.9, 0.2, 0.1> } no_image }
sphere { <-0.6, 0.4, 0.3>, 0.4 pigment { rgb <0.2, 0.9, 0.1> } no_reflection }
sphere { <0.7, 0.4, 0.3>, 0.4 pigment { rgb <0.2, 0.3, 0.9> } no_image no_reflection }
sphere { <1.8, 0.4, 0.3>, 0.4 pigment { rgb <0.9, 0.9, 0.2> } no_reflection }
box { <0.3, 0, -1.5>, <2.6, 1.2, -1.45> pigment { rgbt <0.9, 1, 1, 0.8> } interior { ior 1.2 } }
