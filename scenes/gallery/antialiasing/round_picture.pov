#version 3.7;
// The rim of a round picture: places without a ray are black and transparent.
global_settings { assumed_gamma 1 }
camera { fisheye location <0, 0.5, 0> angle 180 right 4/3*x up y }
light_source { <4, 6, -5>, rgb 1 }
background { rgb <0.7, 0.8, 1> }
plane { y, -0.5 pigment { checker rgb 0.9, rgb <0.1, 0.2, 0.3> scale 0.7 } }
sphere { <0.5, 0.6, 3>, 1 pigment { rgb <0.8, 0.3, 0.1> } }
