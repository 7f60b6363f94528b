#version 3.7;
// right between up and 1.283458 up.
#include "surroundings.inc"

camera { omnimax location <0.1, 0.4, -0.5> right 1.15*x up y look_at <0.3, 1.5, 4> }
