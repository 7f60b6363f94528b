// black_hole with repeat and turbulence; holes that do not fit are moved.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <0.15, 0.2, 0.35>, rgb <1, 0.85, 0.6> scale 0.05 warp { black_hole <0.15, 0.15, 0>, 0.14 repeat <0.3, 0.3, 0> } } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <0.15, 0.2, 0.35>, rgb <1, 0.85, 0.6> scale 0.05 warp { black_hole <0.15, 0.15, 0.15>, 0.12 repeat <0.4, 0.4, 0.4> turbulence <0.1, 0.1, 0> inverse } } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { Ramp } scale 0.1 warp { black_hole 0.05, 0.12 repeat <0.2, 0.2, 0> } } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient y color_map { Ramp } scale 0.1 warp { black_hole <0.1, 0.2, 0>, 0.1 strength 3 turbulence 0.05 repeat <0.3, 0.5, 0.4> } } translate <1, 0, 0> }
