// tiling 1 to 12.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2.0, 1.5, -20> direction 20 * z up 3 * y right 4 * x look_at <2.0, 1.5, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 1 color_map { Ramp } rotate -90*x scale 0.12 } translate <0, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 2 color_map { Ramp } rotate -90*x scale 0.12 } translate <1, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 3 color_map { Ramp } rotate -90*x scale 0.12 } translate <2, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 4 color_map { Ramp } rotate -90*x scale 0.12 } translate <3, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 5 color_map { Ramp } rotate -90*x scale 0.12 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 6 color_map { Ramp } rotate -90*x scale 0.12 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 7 color_map { Ramp } rotate -90*x scale 0.12 } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 8 color_map { Ramp } rotate -90*x scale 0.12 } translate <3, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 9 color_map { Ramp } rotate -90*x scale 0.12 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 10 color_map { Ramp } rotate -90*x scale 0.12 } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 11 color_map { Ramp } rotate -90*x scale 0.12 } translate <2, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { tiling 12 color_map { Ramp } rotate -90*x scale 0.12 } translate <3, 0, 0> }
