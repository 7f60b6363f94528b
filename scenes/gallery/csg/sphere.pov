// sphere in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { sphere { <0.1, 0, 0>, 0.9 } }
Nested(Shape)
