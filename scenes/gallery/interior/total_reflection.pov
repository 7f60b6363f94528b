// Prisms: total internal reflection takes neither the filter nor the mirror of the top layer.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
global_settings { max_trace_level 10 }
prism { -0.8, 0.8, 3, <-1, 0>, <1, 0>, <0, 1> pigment { rgbf <0.9, 1, 0.9, 0.9> } finish { reflection 0.1 specular 0.5 } interior { ior 1.5 } rotate <-70, 20, 0> translate <-1, 0.8, 0> }
box { <0.6, 0.1, -0.5>, <1.9, 1.3, 0.6> rotate 25*y pigment { rgbft <1, 0.9, 0.8, 0.5, 0.4> } interior { ior 1.6 fade_distance 2 fade_power 1 fade_color rgb <0.8, 0.3, 0.2> } }
