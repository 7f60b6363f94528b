#version 3.7;
// dents.
#include "surroundings.inc"

camera { ultra_wide_angle location <0.1, 0.4, -1> right 4/3*x angle 120 look_at <0.5, 0.2, 4> normal { dents 0.4 scale 0.2 } }
