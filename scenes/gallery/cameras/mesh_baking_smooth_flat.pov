// A smooth mesh camera looks along y from faces without normals.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Sheet = mesh {
  smooth_triangle {
    <0, 0, 0>, <0, 0, -1>, <5, 0, 0>, <1, 0, -1>, <0, 5, 0>, <0, 1, -1> uv_vectors <0, 0>, <1, 0>, <0, 1>
  }
  triangle { <5, 0, 0>, <0, 5, 0>, <5, 5, 3> uv_vectors <1, 0>, <0, 1>, <1, 1> }
}
camera { mesh_camera { 1 3 mesh { Sheet rotate 20 * z } smooth } location 0.01 * z }
sphere { 0, 100 inverse pigment { cells scale 5 } finish { ambient 1 diffuse 0 } }
