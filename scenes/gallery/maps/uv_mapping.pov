// uv_mapping in a pigment: transforms inside and outside.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { uv_mapping checker rgb 0, rgb 1 scale 0.1 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { uv_mapping bozo scale <0.05, 0.2, 1> rotate 30*z } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { uv_mapping gradient x color_map { [0 rgb x] [1 rgb y] } scale 0.3 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient y pigment_map { [0.4 uv_mapping checker scale 0.05] [0.6 bozo scale 0.1] } } translate <1, 0, 0> }
