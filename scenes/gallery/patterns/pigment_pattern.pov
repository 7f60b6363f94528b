// pigment_pattern: the grey of a pigment.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { pigment_pattern { marble turbulence 0.5 scale 0.3 } color_map { Ramp } } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { pigment_pattern { checker rgb <1, 0, 0>, rgb <0, 0, 1> scale 0.2 } color_map { Ramp } rotate 30*z } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { pigment_pattern { bozo color_map { [0.3 rgb x] [0.6 rgb 1] } scale 0.2 } frequency 2 triangle_wave color_map { Ramp } } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { pigment_pattern { pigment_pattern { wood scale 0.2 } turbulence 0.3 color_map { [0 rgb 1] [1 rgb y] } } color_map { Ramp } } translate <1, 0, 0> }
