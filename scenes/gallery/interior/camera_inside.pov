// The camera inside glass: its interior is on the list from the start.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
global_settings { max_trace_level 10 }
sphere { <0, 1.6, -6>, 2 pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.3 } }
box { <-1, 1, -6.5>, <1, 2, -5.5> pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.1 } }
sphere { <0, 0.6, 0>, 0.6 pigment { rgb <0.9, 0.4, 0.2> } }
