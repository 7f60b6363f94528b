#version 3.7;
// Distribution 0: the face of a mesh for each pixel (160 x 120 faces).
#include "surroundings.inc"
#include "grid_mesh.inc"

#declare Grid_80_120 = Make_Grid(80, 120)
camera {
  mesh_camera { 1 0 mesh { Grid_80_120 translate <-0.5, -0.3, 0> scale <7, 5, 1> translate -6*z } }
  location 0.01*z
}
