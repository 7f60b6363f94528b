// Light fades on its way through coloured glass: by a power, by an exponential law, and only by half
// where the power is 0.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
box { <-2.4, 0, -0.5>, <-1.5, 1.2, 0.5> rotate 0 pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.3 fade_distance 0.5 fade_power 2 } }
box { <-1.1, 0, -0.5>, <-0.20000000000000007, 1.2, 0.5> rotate 0 pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.3 fade_distance 0.6 fade_power 1001 fade_color rgb <0.9, 0.4, 0.1> } }
box { <0.2, 0, -0.5>, <1.1, 1.2, 0.5> rotate 0 pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.3 fade_distance 1 fade_color rgb <0.2, 0.8, 0.3> } }
box { <1.5, 0, -0.5>, <2.4, 1.2, 0.5> rotate 0 pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.3 fade_distance 0.3 fade_power 3 fade_colour rgb <0.1, 0.3, 0.9> } }
