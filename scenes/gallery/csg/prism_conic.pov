// prism_conic in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { prism { conic_sweep linear_spline 0, 1.2, 5, <0.7, 0.7>, <-0.7, 0.7>, <-0.7, -0.7>, <0.7, -0.7>, <0.7, 0.7> translate -0.7*y rotate 20*x } }
Nested(Shape)
