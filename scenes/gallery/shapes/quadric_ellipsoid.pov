// quadric_ellipsoid: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { quadric { <1.4, 1.8, 2>, <0.3, 0.2, 0.1>, <0.1, -0.2, 0.3>, -0.9 } }
Moved(Shape)
