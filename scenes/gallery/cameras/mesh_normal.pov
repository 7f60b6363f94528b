#version 3.7;
// A normal in a mesh camera is looked up at one point: all rays turn alike.
#include "surroundings.inc"
#include "grid_mesh.inc"

#declare Grid_80_120 = Make_Grid(80, 120)
camera {
  mesh_camera { 1 0 mesh { Grid_80_120 translate <-0.5, -0.3, 0> scale <7, 5, 1> translate -6*z } }
  normal { bumps 0.3 translate <0.3, 0.2, 0.1> }
}
