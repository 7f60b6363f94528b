// object: inside and outside, as colours and as pigments; cut shapes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { object { sphere { 0.5, 0.4 } rgb <0.2, 0.3, 0.6>, rgb <1, 0.9, 0.5> } } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { object { difference { box { 0.1, 0.9 } cylinder { <0.5, 0.5, -1>, <0.5, 0.5, 2>, 0.25 } } pigment { bozo scale 0.1 } pigment { checker scale 0.1 } } } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { object { torus { 0.3, 0.12 rotate 90*x translate <0.5, 0.5, 0.1> } rgb 0, rgb <1, 0.4, 0.2> } turbulence 0.2 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { object { merge { sphere { <0.3, 0.5, 0>, 0.3 } sphere { <0.7, 0.5, 0>, 0.3 inverse } } } rotate 20*z } translate <1, 0, 0> }
