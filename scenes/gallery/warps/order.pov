// warps and transforms undo the last written item first.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.0, -20> direction 20 * z up 2.25 * y right 3 * x look_at <1.5, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <0.15, 0.2, 0.35>, rgb <1, 0.85, 0.6> scale 0.1 rotate 30*z translate 0.05*x } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <0.15, 0.2, 0.35>, rgb <1, 0.85, 0.6> translate 0.5*x rotate 30*z scale 0.1 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { Ramp } warp { repeat 0.5*x flip x } rotate 45*z scale 0.4 } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { Ramp } scale 0.4 rotate 45*z warp { repeat 0.3*x flip x } } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { Ramp } scale 0.3 warp { turbulence 0.2 } warp { repeat 0.3*y flip y } } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { Ramp } scale 0.3 warp { repeat 0.3*y flip y } warp { turbulence 0.2 } } translate <2, 0, 0> }
