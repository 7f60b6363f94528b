#version 3.7;
// look_at before location, sky leaning, transforms between the modifiers.
#include "surroundings.inc"

camera { look_at <0.5, 0.3, 4> translate <0.4, 0.2, 0> sky <0.3, 1, 0.1> angle 80 location <-2, 1.5, -3> rotate y*11 right 4/3*x }
