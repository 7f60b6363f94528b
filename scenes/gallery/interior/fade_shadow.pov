// The shadows of fading glass: the fade acts where the shadow ray leaves the body.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-1, 5, 3> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
sphere { <-1.5, 0.7, 0>, 0.5 pigment { rgbf <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0.1 } interior { ior 1.2 fade_distance 0.5 fade_power 2 } }
sphere { <0, 0.7, 0>, 0.5 pigment { rgbf <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0.1 } interior { ior 1.2 fade_distance 1 fade_color rgb <0.2, 0.8, 0.3> } }
sphere { <1.5, 0.7, 0>, 0.5 pigment { rgbf <1, 1, 1, 0.9> } finish { ambient 0 diffuse 0.1 } interior { ior 1.2 fade_distance 0.5 fade_power 1000 fade_color rgb <0.9, 0.2, 0.1> } }
