// polygon: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { polygon { 12, <-0.8, -0.8>, <0.8, -0.8>, <0.4, 0>, <0.8, 0.8>, <-0.8, 0.8>, <-0.8, -0.8>, <-0.4, -0.4>, <0.3, -0.4>, <0, 0>, <0.3, 0.4>, <-0.4, 0.4>, <-0.4, -0.4> rotate <10, 20, 0> } }
Moved(Shape)
