// Lists with colours left out, copied lists, a list of pigments cut short.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.5, -20> direction 20 * z up 3 * y right 4 * x look_at <1.5, 1.5, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Tiles = pigment { checker rgb 1, rgb <0.6, 0.2, 0.2> scale 0.15 }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <1, 0.6, 0.2> scale 0.2 } translate <0, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { hexagon rgb 1 rotate 90*x scale 0.12 } translate <1, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { brick rgb <0, 0.5, 0.5> scale 0.1 } translate <2, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { square rgb 1, rgb 0.5 rotate 90*x scale 0.2 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { triangular rgb 1, rgb 0.5, rgb <1, 0.4, 0> rotate 90*x scale 0.2 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { cubic rgb <1, 0.4, 0> translate 0.4 } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { Tiles rotate 45*z } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker pigment { bozo scale 0.1 } scale 0.2 } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { Tiles checker rgb 0, rgb <0.3, 0.6, 1> } translate <2, 0, 0> }
