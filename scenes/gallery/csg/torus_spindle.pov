// torus_spindle in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { torus { 0.35, 0.55 } }
Nested(Shape)
