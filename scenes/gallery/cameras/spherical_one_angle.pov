#version 3.7;
// One angle: half of it is the height; vectors not at right angles.
#include "surroundings.inc"

camera { spherical location <0.1, 0.5, 0.2> angle 240 direction <0.2, 0, 1.3> right <1.5, 0.1, 0> }
