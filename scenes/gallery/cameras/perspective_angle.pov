#version 3.7;
// angle sets the length of direction by the length of right; direction points aside.
#include "surroundings.inc"

camera { perspective location <0, 0.5, -6> direction <0.2, 0.05, 3> right x*image_width/image_height angle 67 }
