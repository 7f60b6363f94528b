// superellipsoid: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { superellipsoid { <0.4, 0.7> scale 0.85 } }
Moved(Shape)
