#version 3.7;
// wrinkles and a rotation.
#include "surroundings.inc"

camera { spherical location <0.1, 0.5, 0.2> angle 200 110 normal { wrinkles 0.2 rotate z*30 scale 0.5 } }
