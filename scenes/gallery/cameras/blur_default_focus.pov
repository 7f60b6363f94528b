#version 3.7;
// No focal_point: the focal distance is the length of direction.
#include "surroundings.inc"

camera { location <0.4, 0.8, -5> direction 7*z right 8*x up 6*y look_at <0.3, 0.1, 3> aperture 0.7 blur_samples 15 }
