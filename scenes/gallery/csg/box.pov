// box in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { box { <-0.8, -0.7, -0.6>, <0.8, 0.7, 0.6> } }
Nested(Shape)
