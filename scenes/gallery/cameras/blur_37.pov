#version 3.7;
// The grid of 37.
#include "surroundings.inc"

camera { location <0.4, 0.8, -5> right 4/3*x angle 50 look_at <0.3, 0.1, 3> aperture 1 blur_samples 37 focal_point <0, 0, 1> variance 0.001 confidence 0.95 }
