#version 3.7;
// waves, on a cylinder of type 2 (its place mixes an angle and a length).
#include "surroundings.inc"

camera { cylinder 2 location <0.1, 0.4, -0.3> right 4/3*x up y angle 100 look_at <0.4, 0.6, 3> normal { waves 0.1 scale 0.2 } }
