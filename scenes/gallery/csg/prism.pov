// prism in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { prism { linear_spline -0.5, 0.5, 6, <-0.8, -0.6>, <0.8, -0.6>, <0.3, 0>, <0.8, 0.7>, <-0.8, 0.6>, <-0.8, -0.6> rotate -50*x } }
Nested(Shape)
