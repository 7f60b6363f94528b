// ovus in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { ovus { 0.75, 0.4 translate -0.3*y } }
Nested(Shape)
