#version 3.7;
// Transforms move the camera, not the focal distance.
#include "surroundings.inc"

camera { location <0.4, 0.8, -5> right 4/3*x angle 50 look_at <0.3, 0.1, 3> aperture 0.7 blur_samples 15 focal_point <0, 0, 4> scale <1, 1, 1.3> rotate y*20 }
