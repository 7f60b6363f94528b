// Layers: filter, transmit, each with its own normal and finish.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#declare Stack = texture { pigment { wood color_map { [0 rgb <0.9, 0.6, 0.3>] [1 rgb <0.5, 0.3, 0.1>] } scale 0.2 } } texture { pigment { granite color_map { [0.2 rgbt 1] [0.5 rgbf <0.2, 0.1, 0.05, 0.3>] } scale 0.4 } finish { phong 0.7 } }
plane { -z, -3 pigment { checker rgb 0.9, rgb 0.2 scale 0.5 } }
sphere { 0, 0.95 texture { pigment { rgb <1, 0.8, 0.5> } } texture { pigment { bozo color_map { [0.4 rgbt 1] [0.6 rgb <0.3, 0.1, 0>] } scale 0.3 } finish { phong 1 } } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 texture { pigment { checker rgb 1, rgb <1, 0, 0> scale 0.3 } normal { bumps 1 scale 0.1 } } texture { pigment { rgbf <0.6, 0.8, 1, 0.8> } finish { specular 0.8 } } translate <0, 1.15, 0> }
sphere { 0, 0.95 texture { pigment { rgb <0.3, 0.5, 1> } finish { reflection 0.4 } } texture { pigment { gradient y color_map { [0.3 rgbft <1, 1, 0.4, 0.5, 0.5>] [0.7 rgbt <1, 0, 0, 0.2>] } scale 0.4 } normal { ripples 0.5 scale 0.2 } } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 texture { Stack } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 texture { Stack rotate 90*z scale 0.6 } translate <0, -1.15, 0> }
sphere { 0, 0.95 texture { pigment { rgbt <1, 1, 1, 0.9> } } texture { pigment { checker rgbt 1, rgb <0.1, 0.5, 0.2> scale 0.3 } } hollow translate <2.3, -1.15, 0> }
