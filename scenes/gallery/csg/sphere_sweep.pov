// sphere_sweep in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { sphere_sweep { cubic_spline 6, <-1, -1, 0>, 0.2, <-0.7, -0.5, 0>, 0.3, <-0.4, 0.6, 0.2>, 0.2, <0.4, 0.5, -0.3>, 0.35, <0.6, -0.5, 0>, 0.2, <0, -1, 0>, 0.1 } }
Nested(Shape)
