// cubic: six faces.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { cubic translate <0.5, 0.4, 0.2> } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { cubic rgb 1, rgb 0.8, rgb 0.6, rgb 0.4, rgb 0.2, rgb 0 rotate <20, 30, 10> translate 0.5 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { cubic turbulence 0.3 translate 0.5 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { cubic pigment { bozo scale 0.1 } pigment { rgb 1 } warp { repeat 0.5*x } warp { repeat 0.5*y } translate 0.25 } translate <1, 0, 0> }
