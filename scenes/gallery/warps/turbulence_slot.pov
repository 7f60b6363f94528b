// the bare turbulence: innermost whatever its place; repeated; parts of it without strength.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.0, -20> direction 20 * z up 2.25 * y right 3 * x look_at <1.5, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x turbulence 0.5 color_map { Ramp } scale 0.3 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { Ramp } scale 0.3 turbulence 0.5 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { Ramp } turbulence 0.3 warp { repeat 0.4*x } scale 0.5 } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { Ramp } turbulence 0.1 octaves 2 turbulence 0.6 scale 0.3 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { Ramp } octaves 3 omega 0.9 scale 0.3 } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { bozo color_map { Ramp } turbulence <0.8, 0, 0> warp { turbulence 0.2 } lambda 3 scale 0.2 } translate <2, 0, 0> }
