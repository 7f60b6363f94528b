#version 3.7;
// Horizontal axis, fixed viewpoint.
#include "surroundings.inc"

camera { cylinder 2 location <0.1, 0.4, -0.3> right 2*x up y angle 100 look_at <0.4, 0.6, 3> }
