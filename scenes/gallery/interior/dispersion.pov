// Prism colours: seven bands by default, three, twenty.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
background { rgb 0.1 }
sphere { <-1.3, 0.6, 0>, 0.55 pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.5 dispersion 1.1 } }
sphere { <0, 0.6, 0>, 0.55 pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.5 dispersion 1.2 dispersion_samples 3 } }
sphere { <1.3, 0.6, 0>, 0.55 pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.5 dispersion 1.05 dispersion_samples 20 } }
box { <-3, 0.3, 2>, <3, 0.5, 2.1> pigment { rgb 1 } finish { ambient 1 } }
