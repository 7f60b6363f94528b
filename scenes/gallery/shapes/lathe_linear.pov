// lathe_linear: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { lathe { linear_spline 5, <0, -0.8>, <0.7, -0.6>, <0.3, 0>, <0.7, 0.6>, <0, 0.8> } }
Moved(Shape)
