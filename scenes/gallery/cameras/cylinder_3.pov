#version 3.7;
// Vertical axis, viewpoint moving along it.
#include "surroundings.inc"

camera { cylinder 3 location <0.1, 0.4, -0.3> right 4/3*x up 3*y angle 220 rotate y*30 }
