// mesh: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { mesh { triangle { <-0.8, -0.7, 0>, <0.8, -0.5, 0.3>, <0, 0.8, -0.2> uv_vectors <0, 0>, <1, 0>, <0.5, 1> } smooth_triangle { <0, 0.8, -0.2>, <0, 0.5, -1>, <0.8, -0.5, 0.3>, <0.3, -0.3, -1>, <0.9, 0.7, 0.6>, <0.5, 0.2, -1> uv_vectors <0.5, 1>, <1, 0>, <1, 1> } } }
Moved(Shape)
