// inside_vector of a mesh with holes: the direction of the test does not turn with the mesh.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 angle 45 }
light_source { <3, 5, -6>, 1 }
#declare Open = mesh2 {
  vertex_vectors { 6, <1, 0, 0>, <-1, 0, 0>, <0, 1, 0>, <0, -1, 0>, <0, 0, 1>, <0, 0, -1> }
  face_indices { 5, <0, 2, 4>, <0, 2, 5>, <1, 2, 4>, <1, 2, 5>, <0, 3, 4> }
  inside_vector <-0.23, -0.84, 0.13>
}
#macro Cut(Turned, X)
  intersection { object { Turned } sphere { <0.1, 0.2, -0.2>, 0.4 } pigment { rgb <1, 0.5, 0.2> } translate <X, 0.8, 0> }
  difference { object { Turned } sphere { <0.1, 0.2, -0.2>, 0.4 } pigment { rgb <0.4, 0.7, 1> } translate <X, -0.8, 0> }
#end
Cut(object { Open scale <0.7, 1, 1> }, -1.2)
Cut(object { Open rotate 40*z }, 0)
Cut(object { Open scale <1, 0.8, 1> rotate <70, 20, 30> }, 1.2)
