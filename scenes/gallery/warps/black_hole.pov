// black_hole: strength, falloff, inverse.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <0.15, 0.2, 0.35>, rgb <1, 0.85, 0.6> scale 0.1 warp { black_hole <0.5, 0.5, 0>, 0.45 } } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <0.15, 0.2, 0.35>, rgb <1, 0.85, 0.6> scale 0.1 warp { black_hole <0.5, 0.5, 0>, 0.45 strength 2 falloff 0.5 } } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <0.15, 0.2, 0.35>, rgb <1, 0.85, 0.6> scale 0.1 warp { black_hole <0.5, 0.5, 0>, 0.45 inverse } } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <0.15, 0.2, 0.35>, rgb <1, 0.85, 0.6> scale 0.1 warp { black_hole <0.4, 0.6, 0.2>, 0.4 falloff 4 strength 0.8 inverse } } translate <1, 0, 0> }
