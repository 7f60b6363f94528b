#version 3.7;
// At least 10, at most 60 samples.
#include "surroundings.inc"

camera { location <0.4, 0.8, -5> right 4/3*x angle 50 look_at <0.3, 0.1, 3> aperture 1.2 blur_samples 10, 60 focal_point <0, 0, 5> variance 0.0005 }
