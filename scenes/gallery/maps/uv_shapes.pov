// uv_mapping of objects: sphere, torus, box, cone, lathe, mesh.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0.2, 0> angle 42 }
light_source { <-5, 8, -10> rgb 0.8 }
#default { finish { ambient 0.4 diffuse 0.6 } }
#declare Paper = texture {
  pigment { checker pigment { gradient x color_map { [0 rgb <1, 0.9, 0.5>] [1 rgb <1, 0.4, 0.1>] } } pigment { rgb <0.2, 0.3, 0.5> } scale <0.1, 0.125, 1> }
}
sphere { 0, 0.9 uv_mapping texture { Paper } translate <-2.4, 1.2, 0> }
torus { 0.7, 0.3 uv_mapping texture { Paper } rotate <-40, 0, 10> translate <0, 1.2, 0> }
box { -0.7, 0.7 uv_mapping texture { Paper } rotate <-20, 30, 0> translate <2.4, 1.2, 0> }
lathe { cubic_spline 6, <0.2, -1.4>, <0.7, -0.8>, <0.3, 0>, <0.8, 0.5>, <0.2, 0.9>, <0, 1.2> uv_mapping texture { Paper } translate <-2.4, -0.9, 0> }
sphere { 0, 0.9 uv_mapping texture { Paper scale <2, 0.5, 1> rotate 20*z } scale <1, 0.7, 1> rotate 30*z translate <0, -0.9, 0> }
mesh {
  triangle { <-1, -1, 0>, <1, -1, 0>, <1, 1, 0> uv_vectors <0, 0>, <1, 0>, <1, 1> }
  triangle { <-1, -1, 0>, <1, 1, 0>, <-1, 1, 0> uv_vectors <0, 0>, <1, 1>, <0.3, 0.8> }
  uv_mapping texture { Paper } rotate 30*y translate <2.4, -0.9, 0>
}
