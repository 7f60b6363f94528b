#version 3.7;
// Horizontal axis, viewpoint moving along it.
#include "surroundings.inc"

camera { cylinder 4 location <0.1, 0.4, -0.3> right 5*x up y angle 120 look_at <0.4, 0.6, 3> }
