#version 3.7;
// Angles bend with the ratio of up and right.
#include "surroundings.inc"

camera { ultra_wide_angle location <0.1, 0.4, -1> right 4/3*x angle 150 look_at <0.5, 0.2, 4> }
