// function: values beyond 1 fold, negative ones wrap; patterns inside functions.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
#include "functions.inc"
#declare G = function { pattern { granite turbulence 0.2 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { function { sin(x * 20) * cos(y * 15) } color_map { Ramp } } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { function { x * x * 6 - y } color_map { Ramp } } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { function { f_spiral(x - 0.5, y - 0.5, z, 0.3, 0.05, 0.3, 0, 0, 1) } color_map { Ramp } } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { function { G(x, y * 2, 0) * 0.5 + x } color_map { Ramp } } translate <1, 0, 0> }
