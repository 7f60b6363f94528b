#version 3.7;
// Focal blur over half a turn.
#include "surroundings.inc"

camera { panoramic location <0.1, 0.6, 0.2> aperture 0.3 blur_samples 10 focal_point <0, 0, 4> rotate y*50 }
