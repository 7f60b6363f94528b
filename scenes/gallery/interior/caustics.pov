// Caustics that are only painted: shadows are brighter where the light crosses head-on.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-1, 5, 2> rgb 0.8 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
sphere { <-1.5, 0.6, 0>, 0.5 pigment { rgbf <1, 0.6, 0.6, 0.9> } finish { ambient 0 diffuse 0.1 }  interior { ior 1.3 caustics 0.3 } }
sphere { <0, 0.6, 0>, 0.5 pigment { rgbf <0.6, 1, 0.6, 0.9> } finish { ambient 0 diffuse 0.1 } normal { bumps 0.6 scale 0.2 } interior { ior 1.3 caustics 0.6 } }
sphere { <1.5, 0.6, 0>, 0.5 pigment { rgbf <0.7, 0.7, 1, 0.9> } finish { ambient 0 diffuse 0.1 }  interior { ior 1.3 caustics 1 } }
