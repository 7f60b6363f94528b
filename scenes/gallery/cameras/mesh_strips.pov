#version 3.7;
// Distribution 2: an upright strip of the picture for each mesh.
#include "surroundings.inc"
#include "grid_mesh.inc"

#declare Grid_80_80 = Make_Grid(80, 80)
#declare Grid_60_80 = Make_Grid(60, 80)
#declare Grid_80_90 = Make_Grid(80, 90)
camera {
  mesh_camera {
    1 2
    mesh { Grid_80_80 translate <-0.5, -0.3, 0> scale <7, 5, 1> translate -6*z }
    mesh { Grid_60_80 translate <-0.5, -0.3, 0> scale <7, 5, 1> rotate -20*y translate -5*z }
    mesh { Grid_80_90 translate <-0.5, -0.3, 0> scale <7, 5, 1> rotate 10*x translate -6*z }
  }
}
