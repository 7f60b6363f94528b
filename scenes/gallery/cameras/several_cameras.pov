#version 3.7;
// The last one renders, and starts from the defaults again.
#include "surroundings.inc"

camera { location <9, 9, 9> angle 20 look_at 0 }
#declare Chosen = camera { location <-1, 1, -6> right 4/3*x angle 60 look_at <0, 0, 2> }
camera { Chosen rotate y*23 translate <0.3, 0, 0.2> }
