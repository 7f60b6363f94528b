#version 3.7;
// A wide angle, vectors of unequal length.
#include "surroundings.inc"

camera { fisheye location <0.2, 0.5, 0.1> right 4/3*x up y angle 200 look_at <1, 0.3, 3> }
