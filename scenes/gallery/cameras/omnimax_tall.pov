#version 3.7;
// right shorter than up.
#include "surroundings.inc"

camera { omnimax location <0.1, 0.4, -0.5> right 0.8*x up y look_at <0.3, 1.5, 4> }
