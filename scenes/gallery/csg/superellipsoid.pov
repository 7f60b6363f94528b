// superellipsoid in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { superellipsoid { <0.4, 0.7> scale 0.85 } }
Nested(Shape)
