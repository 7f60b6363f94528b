// A scene of language 3.1: noise generator 1, filter turned into transmit in upper layers.
#version 3.1;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
sphere { 0, 0.95 texture { pigment { bozo scale 0.2 } } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 texture { pigment { rgb <1, 0.7, 0.5> } } texture { pigment { bozo color_map { [0.4 rgbf <1, 1, 1, 1>] [0.6 rgbf <0.2, 0.3, 0.8, 0.3>] } scale 0.3 } } translate <0, 1.15, 0> }
sphere { 0, 0.95 pigment { marble turbulence 0.6 scale 0.3 } normal { dents 1 scale 0.2 } translate <2.3, 1.15, 0> }
