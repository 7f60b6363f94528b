// mesh_inside in every kind of CSG.
#version 3.7;
#include "stage.inc"
#declare Mesh = mesh2 {
  vertex_vectors { 6, <0.9, 0, 0>, <-0.9, 0, 0>, <0, 0.9, 0>, <0, -0.9, 0>, <0, 0, 0.9>, <0, 0, -0.9> }
  normal_vectors { 6, x, -x, y, -y, z, -z }
  uv_vectors { 4, <0, 0>, <1, 0>, <0.5, 1>, <0.2, 0.7> }
  face_indices { 8, <0, 2, 4>, <2, 1, 4>, <1, 3, 4>, <3, 0, 4>, <2, 0, 5>, <1, 2, 5>, <3, 1, 5>, <0, 3, 5> }
  uv_indices { 8, <0, 1, 2>, <0, 1, 3>, <0, 1, 2>, <1, 2, 3>, <0, 1, 2>, <0, 1, 2>, <3, 1, 2>, <0, 3, 2> }
  normal_indices { 8, <0, 2, 4>, <2, 1, 4>, <1, 3, 4>, <3, 0, 4>, <2, 0, 5>, <1, 2, 5>, <3, 1, 5>, <0, 3, 5> }
  inside_vector <0.3, 0.5, 0.7>
}
#declare Shape = object { Mesh }
Nested(Shape)
