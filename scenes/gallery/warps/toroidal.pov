// toroidal: major_radius, orientation and dist_exp.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <0.15, 0.2, 0.35>, rgb <1, 0.85, 0.6> scale 0.08 warp { toroidal major_radius 0.3 } rotate 80*x translate 0.5 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <0.15, 0.2, 0.35>, rgb <1, 0.85, 0.6> scale 0.1 warp { toroidal major_radius 0.4 orientation y dist_exp 1 } translate <0.5, 0.5, 0.2> } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { bozo color_map { Ramp } scale 0.1 warp { toroidal orientation x dist_exp 0.7 } translate <0.3, 0.6, 0> } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient y frequency 6 color_map { Ramp } warp { toroidal major_radius 0.25 } rotate 90*x translate 0.5 } translate <1, 0, 0> }
