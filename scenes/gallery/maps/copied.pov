// Copies of pigments: another pattern keeps wave, map and warps; a map by name.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.0, -20> direction 20 * z up 2.25 * y right 3 * x look_at <1.5, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Colours = color_map { [0 rgb <0.1, 0, 0.3>] [0.6 rgb <1, 0.6, 0.2>] [1 rgb 1] }
#declare Base = pigment { gradient y triangle_wave color_map { Colours } warp { turbulence 0.3 } scale 0.3 }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { Base } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { Base bozo } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { Base frequency 3 scale 2 } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x color_map { Colours } scale 0.2 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { Base marble } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { Base wood sine_wave rotate 90*x } translate <2, 0, 0> }
