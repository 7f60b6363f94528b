// lathe_linear in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { lathe { linear_spline 5, <0, -0.8>, <0.7, -0.6>, <0.3, 0>, <0.7, 0.6>, <0, 0.8> } }
Nested(Shape)
