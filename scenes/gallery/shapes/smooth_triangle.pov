// smooth_triangle: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { union { smooth_triangle { <-0.8, -0.7, 0>, <-0.4, 0, -1>, <0.8, -0.5, 0.3>, <0.3, -0.3, -1>, <0, 0.8, -0.2>, <0, 0.5, -1> } smooth_triangle { <0, 0.8, -0.2>, <0, 0.5, -1>, <0.8, -0.5, 0.3>, <0.3, -0.3, -1>, <0.9, 0.7, 0.6>, <0.5, 0.2, -1> } } }
Moved(Shape)
