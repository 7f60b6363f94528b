// text: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { text { ttf "timrom.ttf" "Rq8" 0.4, 0 translate <-0.75, -0.3, -0.2> } }
Moved(Shape)
