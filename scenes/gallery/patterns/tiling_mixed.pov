// tiling 13 to 24.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.0, 1.5, -20> direction 20 * z up 3 * y right 4 * x look_at <2.0, 1.5, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 13 color_map { Ramp } rotate -90*x scale 0.12 } translate <0, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 14 color_map { Ramp } rotate -90*x scale 0.12 } translate <1, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 15 color_map { Ramp } rotate -90*x scale 0.12 } translate <2, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 16 color_map { Ramp } rotate -90*x scale 0.12 } translate <3, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 17 color_map { Ramp } rotate -90*x scale 0.12 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 18 color_map { Ramp } rotate -90*x scale 0.12 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 19 color_map { Ramp } rotate -90*x scale 0.12 } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 20 color_map { Ramp } rotate -90*x scale 0.12 } translate <3, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 21 color_map { Ramp } rotate -90*x scale 0.12 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 22 color_map { Ramp } rotate -90*x scale 0.12 } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 23 color_map { Ramp } rotate -90*x scale 0.12 } translate <2, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 24 color_map { Ramp } rotate -90*x scale 0.12 } translate <3, 0, 0> }
