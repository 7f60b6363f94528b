// Planes of meshes are single precision, worked out of the corners as given (mesh) or as kept (mesh2):
// the pigment behind the glass shows what is below 1e-9. Flat and smooth, moved, pigment on the mesh.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0.1, 0.2, -9> look_at <0, 0.1, 0> angle 40 }
background { rgb <0.3, 0.4, 0.6> }
#declare Digits = texture {
  pigment { function { mod(x * pow(2, 26), 1) + 0.5 } }
  finish { ambient 1 diffuse 0 }
}
polygon { 5, <-9, -9, 5>, <9, -9, 5>, <9, 9, 5>, <-9, 9, 5>, <-9, -9, 5> texture { Digits } }
#declare Glass = material {
  texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
  interior { ior 1.5 }
}
#declare A = <-0.71, -0.53, -0.37>;
#declare B = <0.83, -0.61, -0.29>;
#declare C = <0.07, 0.91, -0.43>;
#declare D = <0.11, -0.13, 0.79>;
#macro Face(P, Q, R) triangle { P, Q, R } #end
#macro SmoothFace(P, Q, R) smooth_triangle { P, P, Q, Q, R, R } #end
#declare Flat = mesh { Face(A, B, C) Face(A, B, D) Face(B, C, D) Face(C, A, D) inside_vector y }
#declare Smooth = mesh {
  SmoothFace(A, B, C)
  SmoothFace(A, B, D)
  SmoothFace(B, C, D)
  SmoothFace(C, A, D)
  inside_vector y
}
#declare Listed = mesh2 {
  vertex_vectors { 4, A, B, C, D }
  face_indices { 4, <0, 1, 2>, <0, 1, 3>, <1, 2, 3>, <2, 0, 3> }
  inside_vector y
}
#declare SmoothListed = mesh2 {
  vertex_vectors { 4, A, B, C, D }
  normal_vectors { 4, A, B, C, D }
  face_indices { 4, <0, 1, 2>, <0, 1, 3>, <1, 2, 3>, <2, 0, 3> }
  inside_vector y
}
object { Flat material { Glass } translate <-2.3, 1.3, 0> }
object { Smooth material { Glass } translate <-0.7, 1.3, 0> }
object { Listed material { Glass } translate <0.8, 1.3, 0> }
object { SmoothListed material { Glass } translate <2.3, 1.3, 0> }
object { Flat material { Glass } rotate <20, 30, 10> translate <-2.3, -1, 0> }
object { Smooth material { Glass } scale <0.7, 1, 1.2> translate <-0.7, -1, 0> }
object { Listed texture { Digits } rotate <-40, 70, 10> translate <0.8, -1, 0> }
object { SmoothListed material { Glass } matrix <1, 0.2, 0, 0, 0.9, 0, 0.3, 0, 1, 2.3, -1, 0> }
