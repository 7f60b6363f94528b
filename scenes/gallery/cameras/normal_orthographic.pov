#version 3.7;
// quilted in an orthographic camera; the rays stay where they start.
#include "surroundings.inc"

camera { orthographic location <-1, 2, -8> right 9*x up 6*y look_at <0, 0.5, 0> normal { quilted 0.2 control0 1 control1 0.5 scale 0.13 } }
