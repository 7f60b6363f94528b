#version 3.7;
// Vertical axis, fixed viewpoint.
#include "surroundings.inc"

camera { cylinder 1 location <0.1, 0.4, -0.3> right 4/3*x up 1.2*y angle 160 look_at <0.4, 0.3, 3> }
