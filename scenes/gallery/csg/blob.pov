// blob in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { blob { threshold 0.5 sphere { -0.4*x, 0.8, 1 } sphere { 0.4*x, 0.8, 1 } cylinder { -0.8*y, 0.8*y, 0.4, 0.8 } } }
Nested(Shape)
