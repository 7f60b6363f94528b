// Normals of polygons, triangles and smooth triangles have povray's last digits: mirrors and panes, and what
// is below 1e-12 behind and before them.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0.1, 0.2, -9> look_at <0, 0.1, 0> angle 40 }
background { rgb <0.3, 0.4, 0.6> }
#declare Digits = texture {
  pigment { function { mod(x * pow(2, 42), 1) + 0.5 } }
  finish { ambient 1 diffuse 0 }
}
box { <-9, -9, 5>, <9, 9, 6> texture { Digits } }
box { <-9, -9, -12>, <9, 9, -11> texture { Digits } }
#declare Mirror = texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }
#declare A = <-0.71, -0.53, -0.37>;
#declare B = <0.83, -0.61, -0.29>;
#declare C = <0.07, 0.91, -0.43>;
#declare NA = <-0.2, -0.1, -1>;
#declare NB = <0.3, -0.1, -1>;
#declare NC = <0.1, 0.4, -1>;
#default { texture { Mirror } }
triangle { A, B, C rotate <10, 20, 30> translate <-2.2, 1.2, 0> }
triangle { A, B, C scale <1, 0.7, 1.4> translate <-0.7, 1.2, 0> }
smooth_triangle { A, NA, B, NB, C, NC translate <0.8, 1.2, 0> }
smooth_triangle { A, NA, B, NB, C, NC rotate <10, 20, 30> translate <2.3, 1.2, 0> }
smooth_triangle { A, NA, B, NB, C, NC scale <1, 0.7, 1.4> translate <-2.2, -1, 0> }
polygon { 4, A, B, C, A translate <-0.7, -1, 0> }
polygon { 4, A, B, C, A rotate <20, -30, 10> translate <0.8, -1, 0> }
mesh { smooth_triangle { A, NA, B, NB, C, NC } rotate <10, 20, 30> translate <2.3, -1, 0> }
