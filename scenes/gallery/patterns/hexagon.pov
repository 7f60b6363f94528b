// hexagon: three colours, pigments.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { hexagon rotate 90*x scale 0.1 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { hexagon rgb 1, rgb 0.5, rgb 0 rotate 90*x scale 0.07 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { hexagon pigment { granite scale 0.3 } pigment { rgb <0.5, 0.7, 1> } pigment { bozo scale 0.1 } rotate 90*x scale 0.15 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { hexagon rgb x rgb y rgb z turbulence 0.2 rotate <60, 20, 0> scale 0.1 } translate <1, 0, 0> }
