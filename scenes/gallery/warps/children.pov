// entries of a map see the warps of the parent, except the slots of marble and wood.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x pigment_map { [0.5 checker rgb 0, rgb 1 scale 0.2] [0.5 gradient y scale 0.2] } turbulence 0.5 scale 0.5 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { marble pigment_map { [0.5 checker rgb 0, rgb 1 scale 0.2] [0.5 gradient y scale 0.2] } turbulence 0.5 scale 0.4 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { wood pigment_map { [0.5 checker rgb 0, rgb 1 scale 0.2] [0.5 gradient y scale 0.2] } turbulence 0.1 scale 0.4 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient y pigment_map { [0.3 rgb 1] [0.7 bozo scale 0.3] } warp { repeat 0.5*x flip x } rotate 30*z scale 0.8 } translate <1, 0, 0> }
