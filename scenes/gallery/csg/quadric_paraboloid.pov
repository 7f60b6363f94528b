// quadric_paraboloid in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { intersection { quadric { <1, 0, 1>, <0, 0, 0>, <0, -1, 0>, 0 } plane { y, 0.9 } translate -0.5*y } }
Nested(Shape)
