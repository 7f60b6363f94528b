// brick: size and mortar; the default colours.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { brick scale 0.08 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { brick rgb 0.9, rgb <0.7, 0.2, 0.1> brick_size <4, 2, 3> mortar 0.3 scale 0.1 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { brick pigment { rgb 1 } pigment { bozo scale 0.3 } mortar 0.8 scale 0.07 rotate 30*z } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { brick rgb 0, rgb 1 brick_size 3 mortar 1 scale 0.08 translate <-0.3, -0.7, 0.2> } translate <1, 0, 0> }
