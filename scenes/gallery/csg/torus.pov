// torus in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { torus { 0.65, 0.3 rotate 50*x } }
Nested(Shape)
