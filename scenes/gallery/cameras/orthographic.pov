#version 3.7;
// angle with look_at: the picture is as wide as the view at look_at.
#include "surroundings.inc"

camera { orthographic location <2, 2, -8> right 4/3*x angle 45 look_at <0, 0, 1> }
