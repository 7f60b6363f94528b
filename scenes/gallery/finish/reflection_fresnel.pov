// Mirrors by Fresnel's law, of one colour and of two, with and without an index of refraction.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
#declare I = interior { ior 1.6 };
sphere { <-1.95, 0.6, 0>, 0.6 pigment { rgb <0.2, 0.2, 0.25> } finish { reflection { 1 fresnel } } interior { I } }
sphere { <-0.65, 0.6, 0>, 0.6 pigment { rgb <0.2, 0.2, 0.25> } finish { reflection { 0.2, 0.9 fresnel on } } interior { I } }
sphere { <0.65, 0.6, 0>, 0.6 pigment { rgb <0.2, 0.2, 0.25> } finish { reflection { 1 fresnel metallic } } interior { ior 3 } }
sphere { <1.95, 0.6, 0>, 0.6 pigment { rgb <0.2, 0.2, 0.25> } finish { reflection { 1 fresnel } } interior {  } }
