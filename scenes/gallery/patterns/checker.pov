// checker: colours, the default list, pigments, frequency that makes it blend.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.0, -20> direction 20 * z up 2.25 * y right 3 * x look_at <1.5, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker scale 0.2 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <1, 0.8, 0.6>, rgb <0.2, 0.3, 0.4> scale 0.15 rotate 30*z } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker pigment { bozo scale 0.05 } pigment { gradient x scale 0.2 } scale 0.25 } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb 0, rgb 1 frequency 0.4 phase 0.2 scale 0.2 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb <1, 0.5, 0> scale 0.25 } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { checker rgb 1, rgb <0, 0, 1> turbulence 0.3 scale 0.2 } translate <2, 0, 0> }
