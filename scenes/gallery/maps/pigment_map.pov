// pigment_map: pigments blend; nested maps; solid entries.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.0, -20> direction 20 * z up 2.25 * y right 3 * x look_at <1.5, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x pigment_map { [0.2 rgb <1, 0, 0>] [0.6 bozo scale 0.1] [0.9 checker rgb 1, rgb 0.5 scale 0.1] } } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { bozo pigment_map { [0.4 gradient x scale 0.1] [0.6 gradient y scale 0.1] } scale 0.3 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker pigment { radial frequency 8 rotate 90*x } pigment { wood scale 0.1 } scale 0.3 } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient y pigment_map { [0.3 marble turbulence 0.5 scale 0.2] [0.7 crackle pigment_map { [0.1 rgb 0] [0.3 granite] } scale 0.15] } } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { spherical pigment_map { [0 agate scale 0.2] [1 rgb <0, 0.3, 0.6>] } scale 0.5 translate 0.5 } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { hexagon pigment { rgb x } pigment { bozo scale 0.2 } pigment { leopard scale 0.03 } rotate 90*x scale 0.15 } translate <2, 0, 0> }
