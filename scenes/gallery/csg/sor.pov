// sor in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { sor { 6, <0.2, -1.1>, <0.6, -0.8>, <0.3, -0.2>, <0.7, 0.3>, <0.3, 0.8>, <0, 1> } }
Nested(Shape)
