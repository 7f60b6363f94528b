#version 3.7;
// The lens bends first, the normal after it.
#include "surroundings.inc"

camera { location <0.4, 0.8, -5> right 4/3*x angle 50 look_at <0.3, 0.1, 3> aperture 0.5 blur_samples 10 focal_point <0, 0, 3> normal { bumps 0.1 scale 0.2 } }
