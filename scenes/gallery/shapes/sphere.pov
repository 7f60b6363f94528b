// sphere: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { sphere { <0.1, 0, 0>, 0.9 } }
Moved(Shape)
