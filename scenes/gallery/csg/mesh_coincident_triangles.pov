// Triangles that coincide within a mesh: which is seen depends on the order in which povray finds them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 1, -6> look_at <0, 0.1, 0> angle 45 }
light_source { <4, 6, -6>, rgb 1 }
plane { y, -1.3 pigment { checker rgb 1, rgb 0.5 } }
#declare Twice = mesh2 {
  vertex_vectors {
    6, <-0.9, -0.7, 0.2>, <0.8, -0.9, -0.3>, <0.1, 0.9, 0.1>,
    <0.5, 0.4, 0.9>, <-0.6, 0.5, -0.8>, <0, -0.2, 0.6>
  }
  texture_list {
    4, texture { pigment { rgb <1, 0.2, 0.1> } } texture { pigment { rgb <0.2, 1, 0.1> } }
    texture { pigment { rgb <0.2, 0.3, 1> } } texture { pigment { checker scale 0.2 } }
  }
  face_indices {
    14, <0, 1, 2>, 0, <0, 1, 2>, 1, <0, 1, 2>, 2,
    <2, 3, 4>, 0, <3, 2, 4>, 3, <1, 5, 3>, 1, <1, 5, 3>, 3,
    <0, 4, 5>, 2, <0, 4, 5>, 0, <5, 4, 0>, 1, <1, 3, 4>, 3, <1, 3, 4>, 0, <0, 3, 5>, 1, <0, 3, 5>, 2
  }
  inside_vector y
}
object { Twice translate -1.9 * x }
object { Twice rotate <20, 100, 0> translate <0.1, 0, 0> }
object { Twice clipped_by { plane { x, 0.1 inverse } } rotate <0, -70, 0> translate 2 * x }
