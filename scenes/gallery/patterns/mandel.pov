// mandel: the default map, exponents, exterior and interior types.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.0, -20> direction 20 * z up 2.25 * y right 3 * x look_at <1.5, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { mandel 50 scale 0.25 translate <0.65, 0.5, 0> } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { mandel 20 exponent 4 exterior 6, 0.1 color_map { Ramp } scale 0.35 translate 0.5 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { mandel 30 interior 1, 1 exterior 0, 0 color_map { Ramp } scale 0.25 translate <0.65, 0.5, 0> } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { mandel 25 interior 6, 2 exterior 7, 3 color_map { Ramp } scale 0.25 translate <0.65, 0.5, 0> } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { mandel 25 exterior 4, 0.1 interior 2, 1 color_map { Ramp } scale 0.25 translate <0.65, 0.5, 0> } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { mandel 25 exterior 8, 4 interior 5, 3 color_map { Ramp } scale 0.25 translate <0.65, 0.5, 0> } translate <2, 0, 0> }
