#version 3.7;
// radial.
#include "surroundings.inc"

camera { omnimax location <0.1, 0.4, -0.5> right 4/3*x up y look_at <0.3, 1.5, 4> normal { radial 0.1 frequency 6 } }
