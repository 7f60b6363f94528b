// cylinder in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { cylinder { <0, -0.8, 0>, <0.2, 0.8, 0.1>, 0.6 } }
Nested(Shape)
