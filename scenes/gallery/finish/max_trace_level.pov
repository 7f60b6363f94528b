// Two mirrors and glass between them at a trace level of 3: black where it ends; surfaces that do not
// bend the light do not count.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
global_settings { max_trace_level 3 }
box { <-2, 0, 1.5>, <2, 2, 1.6> pigment { rgb 0.1 } finish { reflection 0.9 diffuse 0 } }
box { <-2.2, 0, -1>, <-2.1, 2, 1.6> pigment { rgb 0.1 } finish { reflection 0.9 diffuse 0 } }
sphere { <-1, 0.5, 0>, 0.5 pigment { rgbt <1, 0.9, 0.9, 0.9> } interior { ior 1.4 } finish { reflection 0.3 } }
#for (I, 0, 4) box { <0.2, 0, I*0.2 - 0.5>, <1.8, 1, I*0.2 - 0.45> pigment { rgbt <0.9, 1, 0.9, 0.8> } } #end
