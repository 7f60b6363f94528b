// quadric_paraboloid: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { intersection { quadric { <1, 0, 1>, <0, 0, 0>, <0, -1, 0>, 0 } plane { y, 0.9 } translate -0.5*y } }
Moved(Shape)
