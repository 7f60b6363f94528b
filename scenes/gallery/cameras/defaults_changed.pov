#version 3.7;
// #default{camera{}} is what every later camera begins with.
#include "surroundings.inc"

#default { camera { location <0, 1, -5> right 4/3*x angle 50 } }
camera { look_at <1, 0, 3> }
