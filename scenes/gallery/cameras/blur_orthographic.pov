#version 3.7;
// An orthographic camera loses its parallel rays: all start at the lens.
#include "surroundings.inc"

camera { orthographic location <-1, 2, -8> right 9*x up 6*y look_at <0, 0.5, 0> aperture 0.5 blur_samples 12 focal_point <0, 0, 2> }
