#version 3.7;
// right and up of one length fill the frame with an ellipse; rotated.
#include "surroundings.inc"

camera { fisheye location <0.2, 0.5, 0.1> right x up y angle 140 rotate <20, 40, 10> }
