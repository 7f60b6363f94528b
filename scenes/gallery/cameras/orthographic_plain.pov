#version 3.7;
// Neither angle nor vectors: scaled by the distance to look_at.
#include "surroundings.inc"

camera { orthographic location <1, 1, -6> look_at <0, 0.5, 2> }
