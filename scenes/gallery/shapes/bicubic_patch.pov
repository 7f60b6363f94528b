// bicubic_patch: moved, turned, sheared, mirrored; uv mapped; clipped with an interior_texture.
#version 3.7;
#include "stage.inc"
#declare Shape = object { bicubic_patch { type 1 flatness 0 u_steps 4 v_steps 3 uv_vectors <0, 0>, <1, 0>, <1, 1>, <0, 1> <-0.9, -0.9, 0>, <-0.3, -0.9, 0.5>, <0.3, -0.9, 0>, <0.9, -0.9, 0>, <-0.9, -0.3, 0.4>, <-0.3, -0.3, -1.5>, <0.3, -0.3, 0.6>, <0.9, -0.3, 0>, <-0.9, 0.3, 0>, <-0.3, 0.3, 0.8>, <0.3, 0.3, -1.2>, <0.9, 0.3, 0.3>, <-0.9, 0.9, 0>, <-0.3, 0.9, 0>, <0.3, 0.9, 0.5>, <0.9, 0.9, 0> } }
Moved(Shape)
