// triangular: six colours.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { triangular rotate 90*x scale 0.17 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { triangular rgb 1, rgb 0.8, rgb 0.6, rgb 0.4, rgb 0.2, rgb 0 rotate 90*x scale 0.1 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { triangular rgb x, rgb y rotate <70, 30, 10> scale 0.15 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { triangular turbulence 0.2 rotate 90*x scale 0.2 } translate <1, 0, 0> }
