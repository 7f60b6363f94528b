#version 3.7;
// A negative right mirrors the picture; look_at keeps the handedness.
#include "surroundings.inc"

camera { location <2, 1, -5> right -4/3*x angle 65 look_at <0, 0.2, 1> }
