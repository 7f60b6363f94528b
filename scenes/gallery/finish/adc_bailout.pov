// A coarse adc_bailout cuts off dim mirrors of mirrors, and the layers below dense ones.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
global_settings { adc_bailout 0.2 max_trace_level 10 }
box { <-2.5, 0, 1.5>, <2.5, 2, 1.6> pigment { rgb 0.1 } finish { reflection 0.6 } }
sphere { <-1.2, 0.6, 0>, 0.6 pigment { rgb <0.8, 0.3, 0.2> } finish { reflection 0.55 } }
sphere { <0.2, 0.6, 0>, 0.6 texture { pigment { rgb <0.9, 0.9, 0.1> } } texture { pigment { rgbt <0.2, 0.2, 0.9, 0.15> } } }
sphere { <1.6, 0.6, 0>, 0.6 pigment { rgbt <0.9, 0.9, 1, 0.19> } finish { reflection 0.19 } }
