// quadric_hyperboloid: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { intersection { quadric { <2, -1, 2>, <0, 0, 0>, <0, 0, 0>, -0.3 } box { <-1, -0.8, -1>, <1, 0.8, 1> } } }
Moved(Shape)
