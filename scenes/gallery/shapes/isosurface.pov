// isosurface: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { isosurface { function { x*x + y*y + z*z + 0.3*sin(8*x)*sin(8*y)*sin(8*z) - 0.6 } contained_by { box { -0.9, 0.9 } } max_gradient 5 accuracy 0.0005 } }
Moved(Shape)
