#version 3.7;
// The grid of 7, and further points.
#include "surroundings.inc"

camera { location <0.4, 0.8, -5> right 4/3*x angle 50 look_at <0.3, 0.1, 3> aperture 0.8 blur_samples 12 focal_point <0, 0, 3.5> variance 0.02 }
