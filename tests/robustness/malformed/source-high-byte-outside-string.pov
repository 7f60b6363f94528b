// A byte above 127 outside strings and comments.
#version 3.7;
sphere { <0, 0, 5>, 1 pigment { rgb 1 } }
box { -1, 1 ü }
