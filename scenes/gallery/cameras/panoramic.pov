#version 3.7;
// Vectors that are not of unit length.
#include "surroundings.inc"

camera { panoramic location <0.1, 0.6, 0.2> direction 1.4*z right 1.2*x up 0.8*y rotate y*50 }
