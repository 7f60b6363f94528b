#version 3.7;
// right and up at an odd angle, with a matrix on top.
#include "surroundings.inc"

camera { location <0, 0.5, -4> direction <0, 0, 1.2> right <1.33, 0.3, 0> up <0.2, 1, 0.1> matrix <1, 0.1, 0, 0, 1, 0.2, -0.1, 0, 1, 0, 0.2, 0> }
