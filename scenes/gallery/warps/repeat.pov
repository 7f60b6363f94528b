// repeat: along one axis, with offset and flip; a width below zero.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.0, -20> direction 20 * z up 2.25 * y right 3 * x look_at <1.5, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { spherical color_map { Ramp } scale 0.2 translate 0.2 warp { repeat 0.4*x } } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { spherical color_map { Ramp } scale 0.2 translate <0.2, 0.3, 0> warp { repeat 0.4*x } warp { repeat 0.5*y } } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient <1, 2, 0> color_map { Ramp } scale 0.3 warp { repeat 0.3*x offset <0, 0.1, 0> } } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient <1, 2, 0> color_map { Ramp } scale 0.3 warp { repeat 0.3*y flip y } } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { bozo color_map { Ramp } scale 0.1 warp { repeat 0.25*x flip <1, 0, 1> offset <0, 0.05, 0.1> } } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { Ramp } scale 0.7 warp { repeat -0.3*x } } translate <2, 0, 0> }
