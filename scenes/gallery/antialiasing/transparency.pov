#version 3.7;
// The transmit channel counts as contrast: see-through shapes over a background of their own colour.
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> right 4/3*x angle 50 }
background { rgbt <0, 0, 0, 0.7> }
#default { finish { ambient 0 diffuse 0 emission 1 } }
disc { <-0.7, 0.3, 0>, z, 0.8, 0.5 pigment { rgb 0 } }
disc { <0.6, -0.2, 0>, <1, 0.2, 2>, 0.9 pigment { rgbt <0, 0, 0, 0.45> } }
box { <-1.5, -1, 0.2>, <0.4, -0.7, 0.3> pigment { rgbf <0.1, 0.1, 0.1, 0.6> } rotate z*7 }
