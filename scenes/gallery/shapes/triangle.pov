// triangle: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { union { triangle { <-0.8, -0.7, 0>, <0.8, -0.5, 0.3>, <0, 0.8, -0.2> } triangle { <0, 0.8, -0.2>, <0.8, -0.5, 0.3>, <0.9, 0.7, 0.6> } } }
Moved(Shape)
