#version 3.7;
// ripples over the two angles.
#include "surroundings.inc"

camera { panoramic location <0.1, 0.6, 0.2> normal { ripples 0.15 scale 0.3 translate <1.5, 0.2, 0> } }
