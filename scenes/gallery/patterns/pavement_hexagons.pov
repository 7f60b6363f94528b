// pavement of hexagons.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.0, -20> direction 20 * z up 2.25 * y right 3 * x look_at <1.5, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { pavement number_of_sides 6 number_of_tiles 1 color_map { Ramp } rotate -90*x scale 0.12 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { pavement number_of_sides 6 number_of_tiles 2 form 1 color_map { Ramp } rotate -90*x scale 0.12 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { pavement number_of_sides 6 number_of_tiles 3 pattern 3 interior 1 color_map { Ramp } rotate -90*x scale 0.12 } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { pavement number_of_sides 6 number_of_tiles 4 pattern 5 form 2 color_map { Ramp } rotate -90*x scale 0.12 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { pavement number_of_sides 6 number_of_tiles 5 pattern 22 color_map { Ramp } rotate -90*x scale 0.12 } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { pavement number_of_sides 6 number_of_tiles 5 pattern 11 interior 2 color_map { Ramp } rotate -90*x scale 0.12 } translate <2, 0, 0> }
