#version 3.7;
// Distribution 1: the faces of all meshes one after the other; only the first ray counts.
#include "surroundings.inc"
#include "grid_mesh.inc"

#declare Grid_80_50 = Make_Grid(80, 50)
#declare Grid_80_60 = Make_Grid(80, 60)
camera {
  mesh_camera {
    3 1
    mesh { Grid_80_50 translate <-0.5, -0.1, 0> scale <7, 3, 1> translate -6*z }
    mesh { Grid_80_60 translate <-0.5, -0.5, 0> scale <7, 3, 1> rotate 15*y translate -6*z }
  }
}
