// parametric: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { parametric { function { sin(u)*cos(v)*(0.7 + 0.2*cos(3*v)) }, function { 0.8*cos(u) }, function { sin(u)*sin(v)*0.8 } <0, 0>, <pi, 2*pi> contained_by { box { -1, 1 } } max_gradient 4 accuracy 0.002 precompute 12 x, y, z } }
Moved(Shape)
