// plane in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { intersection { plane { <1, 1, 1>, 0.5 } plane { <-1, 1, -1>, 0.5 } plane { <1, -1, -1>, 0.5 } plane { <-1, -1, 1>, 0.5 } } }
Nested(Shape)
