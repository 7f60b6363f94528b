// cone: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { cone { <0, -0.8, 0>, 0.8, <0, 0.8, 0.1>, 0.2 } }
Moved(Shape)
