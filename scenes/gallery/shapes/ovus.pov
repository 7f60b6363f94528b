// ovus: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { ovus { 0.75, 0.4 translate -0.3*y } }
Moved(Shape)
