// Colours beyond a map: rgbft blend, filter, transmit over a striped ground.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
light_source { <1, 1, -30> rgb 0.3 }
plane { -z, -3 pigment { gradient x color_map { [0.5 rgb 1] [0.5 rgb <0.2, 0.4, 0.2>] } scale 0.1 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { [0 rgbf <1, 0.5, 0.2, 0.9>] [1 rgbt <0.2, 0.5, 1, 0.8>] } } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { bozo color_map { [0.3 rgbt <1, 1, 1, 1>] [0.6 rgbf <0.9, 0.2, 0.1, 0.5>] } scale 0.15 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgbt <1, 0, 0, 0.7>, rgbft <0, 0.4, 1, 0.3, 0.3> scale 0.2 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient y pigment_map { [0.3 rgbf 1] [0.7 gradient x color_map { [0 rgb 0] [1 rgbt 1] }] } } translate <1, 0, 0> }
