// double_cone in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { cone { <0, -0.8, 0>, 0.8, <0, 0.8, 0.1>, -0.5 } }
Nested(Shape)
