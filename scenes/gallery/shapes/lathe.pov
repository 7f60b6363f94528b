// lathe: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { lathe { cubic_spline 7, <0.2, -1.2>, <0.4, -0.8>, <0.8, -0.3>, <0.4, 0.2>, <0.5, 0.6>, <0.1, 0.8>, <0, 1> } }
Moved(Shape)
