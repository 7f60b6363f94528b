// box: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { box { <-0.8, -0.7, -0.6>, <0.8, 0.7, 0.6> } }
Moved(Shape)
