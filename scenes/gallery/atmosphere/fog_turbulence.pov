// Fog thinned by turbulence.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
fog { distance 6 rgb <0.8, 0.7, 0.6> turbulence <0.5, 0.2, 0.5> turb_depth 0.8 octaves 4 omega 0.6 lambda 2.5 }
sphere { <-1.2, 0.6, 0>, 0.6 pigment { rgb <0.9, 0.5, 0.3> } finish { phong 0.5 } }
sphere { <1, 0.5, 2>, 0.5 pigment { rgb <0.3, 0.5, 0.9> } finish { reflection 0.5 } }
cylinder { <2.5, 0, 6>, <2.5, 3, 6>, 0.3 pigment { rgb <0.4, 0.8, 0.4> } }
