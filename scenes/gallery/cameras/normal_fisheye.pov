#version 3.7;
// The normal is looked up at the polar angle and the angle from the axis.
#include "surroundings.inc"

camera { fisheye location <0.2, 0.5, 0.1> right 4/3*x up y angle 180 look_at <1, 0.3, 3> normal { gradient x 0.2 sine_wave scale 0.7 } }
