// torus: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { torus { 0.65, 0.3 rotate 50*x } }
Moved(Shape)
