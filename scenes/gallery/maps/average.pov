// average: weighted means of pigments.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { average pigment_map { [1 rgb <1, 0, 0>] [2 bozo scale 0.1] [0.5 gradient x scale 0.2] } } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { average pigment_map { [gradient x scale 0.3] [gradient y scale 0.3] } } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { average pigment_map { [1 checker rgb 1, rgb 0 scale 0.2] [3 wood scale 0.2] } rotate 30*z scale 0.7 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { average pigment_map { [1 average pigment_map { [1 rgb x] [1 rgb y] }] [1 spherical scale 0.5 translate 0.5] } warp { turbulence 0.3 } } translate <1, 0, 0> }
