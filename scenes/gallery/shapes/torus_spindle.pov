// torus_spindle: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { torus { 0.35, 0.55 } }
Moved(Shape)
