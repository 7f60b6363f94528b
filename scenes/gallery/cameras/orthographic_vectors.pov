#version 3.7;
// up and right given: the view is exactly so large.
#include "surroundings.inc"

camera { orthographic location <-1, 2, -8> right 9*x up 6*y look_at <0, 0.5, 0> }
