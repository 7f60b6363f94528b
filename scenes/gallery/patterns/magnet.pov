// magnet 1 and 2, mandel and julia.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { magnet 1 mandel 30 color_map { Ramp } scale 0.2 translate <0.3, 0.5, 0> } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { magnet 2 mandel 30 color_map { Ramp } scale 0.2 translate <0.3, 0.5, 0> } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { magnet 1 julia <0.8, 0.6>, 20 interior 1, 0.5 color_map { Ramp } scale 0.15 translate 0.5 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { magnet 2 julia <1.2, 0.3>, 20 exterior 3, 0.01 interior 4, 0.5 color_map { Ramp } scale 0.15 translate 0.5 } translate <1, 0, 0> }
