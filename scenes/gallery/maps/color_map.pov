// color_map: blending, two entries at one place, descending places, the old form with two colours.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.0, -20> direction 20 * z up 2.25 * y right 3 * x look_at <1.5, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { [0.2 rgb <1, 0, 0>] [0.5 rgb <0, 1, 0>] [0.8 rgb <0, 0, 1>] } } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { [0.3 rgb 0] [0.5 rgb 1] [0.5 rgb <1, 0.5, 0>] [1 rgb <0, 0.3, 0.6>] } } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { [0.8 rgb <1, 0, 0>] [0.2 rgb <0, 0, 1>] } } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { [0.1, 0.4 color rgb <1, 0, 0> color rgb <0, 1, 0>] [0.4, 0.9 color rgb <0, 0, 1> color rgb 1] } } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { bozo color_map { [0.5 color rgb <1, 0.9, 0.3>] [0.5, color rgb <0.2, 0.3, 0.7>] } scale 0.1 } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient y color_map { [0.4 rgb <2, 0.5, -1>] [0.6 rgb <-1, 0.5, 2>] } } translate <2, 0, 0> }
