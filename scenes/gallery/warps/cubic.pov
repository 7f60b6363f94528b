// cubic: a cube unfolded.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <0.15, 0.2, 0.35>, rgb <1, 0.85, 0.6> scale 0.04 warp { cubic } scale 0.4 translate <0.5, 0.5, 0.2> } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x frequency 4 color_map { Ramp } warp { cubic } rotate <20, 30, 40> translate 0.5 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient y frequency 4 color_map { Ramp } warp { cubic } rotate <40, 10, 20> translate 0.5 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { bozo color_map { Ramp } scale 0.06 warp { cubic } warp { turbulence 0.2 } translate 0.5 } translate <1, 0, 0> }
