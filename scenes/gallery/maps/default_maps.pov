// Patterns without a map: the default colours.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.5, -20> direction 20 * z up 3 * y right 4 * x look_at <1.5, 1.5, 0> }
#default { finish { ambient 1 diffuse 0 } }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { agate scale 0.3 } translate <0, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { bozo scale 0.1 } translate <1, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { marble scale 0.3 turbulence 0.4 } translate <2, 2, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { radial rotate 90*x translate 0.5 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { wood scale 0.2 translate 0.5 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { mandel 30 scale 0.3 translate <0.6, 0.5, 0> } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { granite } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { spotted scale 0.1 } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { mandel 30 exponent 3 scale 0.3 translate 0.5 } translate <2, 0, 0> }
