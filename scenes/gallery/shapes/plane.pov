// plane: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { intersection { plane { <1, 1, 1>, 0.5 } plane { <-1, 1, -1>, 0.5 } plane { <1, -1, -1>, 0.5 } plane { <-1, -1, 1>, 0.5 } } }
Moved(Shape)
