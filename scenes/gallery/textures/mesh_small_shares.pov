// Three textures of a triangle are mixed, and small shares left out, even where all are the same.
#version 3.7;
global_settings { assumed_gamma 1 adc_bailout 0.1 }
camera { location <0, 0, -5> look_at 0 angle 45 }
background { rgb <0.2, 0.3, 0.5> }
#default { finish { ambient 1 diffuse 0 } }
#declare A = texture { pigment { rgb <1, 0.8, 0.3> } }
#declare B = texture { pigment { checker rgb <0.2, 1, 0.4>, rgb <0.3, 0.3, 1> scale 0.2 } }
mesh2 {
  vertex_vectors { 5, <-1.8, -1, 0>, <-0.2, -1.1, 0>, <-1, 0.1, 0>, <-1.9, 1.3, 0>, <-0.1, 1.2, 0> }
  texture_list { 2, texture { A } texture { B } }
  face_indices { 3, <0, 1, 2>, 0, 0, 0, <2, 3, 4>, 1, <0, 2, 3>, 1, 0, 1 }
}
mesh {
  triangle { <0.2, -1, 0>, <1.8, -1.1, 0>, <1, 0.1, 0> texture_list { B B B } }
  triangle { <1, 0.1, 0>, <0.1, 1.3, 0>, <1.9, 1.2, 0> texture { A } }
  triangle { <0.1, -0.8, 0>, <0.9, 0.1, 0>, <0.1, 1.1, 0> texture_list { A B A } }
}
