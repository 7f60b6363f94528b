// prism_cubic: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { prism { cubic_spline -0.5, 0.5, 8, <-0.8, 0>, <0, -0.8>, <0.8, 0>, <0.4, 0.5>, <0, 0.8>, <-0.8, 0.3>, <0, -0.8>, <0.8, 0> rotate -50*x } }
Moved(Shape)
