#version 3.7;
// Non-unit vectors, no look_at, right without the aspect ratio.
#include "surroundings.inc"

camera { location <0.3, 1, -7> direction 1.7*z right 1.1*x up 1.4*y }
