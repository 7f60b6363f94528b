#version 3.7;
// Distribution 0 with two rays for each pixel, each from its own mesh; the second has fewer faces.
#include "surroundings.inc"
#include "grid_mesh.inc"

#declare Grid_80_120 = Make_Grid(80, 120)
#declare Grid_80_70 = Make_Grid(80, 70)
camera {
  mesh_camera {
    2 0
    mesh { Grid_80_120 translate <-0.5, -0.3, 0> scale <7, 5, 1> translate -6*z }
    mesh { Grid_80_70 translate <-0.5, -0.3, 0> scale <7, 5, 1> rotate 5*y translate -6*z }
  }
}
