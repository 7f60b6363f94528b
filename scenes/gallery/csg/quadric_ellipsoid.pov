// quadric_ellipsoid in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Shape = object { quadric { <1.4, 1.8, 2>, <0.3, 0.2, 0.1>, <0.1, -0.2, 0.3>, -0.9 } }
Nested(Shape)
