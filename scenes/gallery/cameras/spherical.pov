#version 3.7;
// All directions by default.
#include "surroundings.inc"

camera { spherical location <0.1, 0.5, 0.2> look_at <1, 0.2, 3> }
