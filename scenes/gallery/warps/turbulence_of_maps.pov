// The turbulence slot of image maps and averages, which have no pattern value.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { image_map { ppm "a.ppm" interpolate 2 } turbulence 0.3 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { image_map { ppm "a.ppm" } scale 0.5 turbulence <0.4, 0, 0> octaves 2 rotate 90*z } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { average pigment_map { [1 gradient x scale 0.3] [1 gradient y scale 0.2] } turbulence 0.4 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { average pigment_map { [1 checker scale 0.2] [1 rgb 1] } turbulence 0.2 warp { repeat 0.5*x flip x } } translate <1, 0, 0> }
