#version 3.7;
// look_at along sky keeps the right vector (a warning).
#include "surroundings.inc"

camera { location <0.2, 9, 0.3> right <1.2, 0, 0.3> direction z look_at <0.2, 0, 0.3> angle 75 }
