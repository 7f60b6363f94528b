// disc: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { disc { <0, 0, 0>, <0.3, 0.5, -1>, 0.9, 0.35 } }
Moved(Shape)
