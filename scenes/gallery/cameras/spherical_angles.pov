#version 3.7;
// Two angles.
#include "surroundings.inc"

camera { spherical location <0.1, 0.5, 0.2> angle 200 70 rotate <10, 60, 5> }
