#version 3.7;
// Focal blur on a round picture: outside there is no ray.
#include "surroundings.inc"

camera { fisheye location <0.2, 0.5, 0.1> right 4/3*x up y angle 170 look_at <1, 0.3, 3> aperture 0.4 blur_samples 12 focal_point <1, 0.3, 4> }
