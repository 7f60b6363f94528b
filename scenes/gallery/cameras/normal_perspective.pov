#version 3.7;
// A bumpy lens.
#include "surroundings.inc"

camera { location <0.3, 0.6, -5> right 4/3*x angle 65 look_at <0, 0.2, 2> normal { bumps 0.15 scale 0.1 } }
