// Shapes of no or negative size, moved and scaled to nothing; CSG of nothing: what remains, remains.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <5.0, 2.0, -20> look_at <5.0, 2.0, 0> up 7.5*y right 10*x }
light_source { <-30, 50, -60>, 1 }
background { rgb <0.2, 0.3, 0.5> }
#declare Place = <0 + 0.5, 3 + 0.5, 0>;
object { sphere { 0, 0 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <1 + 0.5, 3 + 0.5, 0>;
object { sphere { 0, -0.4 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <2 + 0.5, 3 + 0.5, 0>;
object { sphere { 0, 1e-300 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <3 + 0.5, 3 + 0.5, 0>;
object { sphere { 0, 0.4 pigment { rgb <0.9, 0.6, 0.3> } scale 0 } translate Place }
#declare Place = <4 + 0.5, 3 + 0.5, 0>;
object { sphere { 0, 0.4 pigment { rgb <0.9, 0.6, 0.3> } scale <0, 1, 1> } translate Place }
#declare Place = <5 + 0.5, 3 + 0.5, 0>;
object { sphere { 0, 0.4 pigment { rgb <0.9, 0.6, 0.3> } scale <1e-20, 1, 1> } translate Place }
#declare Place = <6 + 0.5, 3 + 0.5, 0>;
object { sphere { 0, 0.4 pigment { rgb <0.9, 0.6, 0.3> } scale -1 } translate Place }
#declare Place = <7 + 0.5, 3 + 0.5, 0>;
object { box { 0, 0 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <8 + 0.5, 3 + 0.5, 0>;
object { box { <-0.4, 0, -0.4>, <0.4, 0, 0.4> pigment { rgb <0.9, 0.6, 0.3> } rotate 30*x } translate Place }
#declare Place = <9 + 0.5, 3 + 0.5, 0>;
object { box { 0.3, -0.3 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <0 + 0.5, 2 + 0.5, 0>;
object { cylinder { 0, 0.4*y, -0.3 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <1 + 0.5, 2 + 0.5, 0>;
object { cylinder { 0, 1e-6*y, 0.4 pigment { rgb <0.9, 0.6, 0.3> } rotate 60*x } translate Place }
#declare Place = <2 + 0.5, 2 + 0.5, 0>;
object { cone { 0, 0.4, 0.3*y, -0.2 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <3 + 0.5, 2 + 0.5, 0>;
object { cone { 0, 0.3, 0.4*y, 0.3 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <4 + 0.5, 2 + 0.5, 0>;
object { disc { 0, 0, 0.4 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <5 + 0.5, 2 + 0.5, 0>;
object { disc { 0, y, 0 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <6 + 0.5, 2 + 0.5, 0>;
object { disc { 0, z, 0.4, 0.5 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <7 + 0.5, 2 + 0.5, 0>;
object { disc { 0, z, 0.4, -0.2 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <8 + 0.5, 2 + 0.5, 0>;
object { torus { 0.3, 0 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <9 + 0.5, 2 + 0.5, 0>;
object { torus { 0.1, 0.3 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <0 + 0.5, 1 + 0.5, 0>;
object { triangle { 0, 0, 0 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <1 + 0.5, 1 + 0.5, 0>;
object { triangle { 0, 0.4*x, 0.4*x pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <2 + 0.5, 1 + 0.5, 0>;
object { smooth_triangle { 0, z, 0.4*x, -z, 0.4*y, z pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <3 + 0.5, 1 + 0.5, 0>;
object { smooth_triangle { 0, -z, 0, -z, 0.4*y, -z pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <4 + 0.5, 1 + 0.5, 0>;
object { polygon { 4, 0, 0.4*x, 0.4*x+0.4*y, 0 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <5 + 0.5, 1 + 0.5, 0>;
object { mesh { triangle { 0, 0.4*x, 0.4*y } triangle { 0, 0, 0 } pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <6 + 0.5, 1 + 0.5, 0>;
object { mesh2 { vertex_vectors { 3, 0, 0.4*x, 0.4*y } face_indices { 2, <0, 1, 2>, <0, 0, 0> } pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <7 + 0.5, 1 + 0.5, 0>;
object { quadric { 0, 0, 0, 1 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <8 + 0.5, 1 + 0.5, 0>;
object { blob { threshold 0.5 sphere { 0, 0.4, 0 } sphere { 0.1*x, 0.4, 1 } pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <0 + 0.5, 0 + 0.5, 0>;
object { prism { 0, 0, 4, <0, 0>, <0.4, 0>, <0, 0.4>, <0, 0> pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <1 + 0.5, 0 + 0.5, 0>;
object { prism { 0.3, 0, 4, <0, 0>, <0.4, 0>, <0, 0.4>, <0, 0> pigment { rgb <0.9, 0.6, 0.3> } rotate 30*x } translate Place }
#declare Place = <2 + 0.5, 0 + 0.5, 0>;
object { lathe { linear_spline 3, <-0.4, 0>, <0.4, 0.2>, <0, 0.4> pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <3 + 0.5, 0 + 0.5, 0>;
object { sphere_sweep { linear_spline 2, 0, 0.1, 0.03*x, 0.4 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <4 + 0.5, 0 + 0.5, 0>;
object { difference { sphere { 0, 0.4 } sphere { 2*x, 0.4 } pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <5 + 0.5, 0 + 0.5, 0>;
object { intersection { sphere { 0, 0.4 } sphere { 2*x, 0.4 } pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <6 + 0.5, 0 + 0.5, 0>;
object { union { sphere { 0, 0.4 } sphere { 0, 0 } pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <7 + 0.5, 0 + 0.5, 0>;
object { sphere { 0, 0.4 pigment { rgb <0.9, 0.6, 0.3> } clipped_by { sphere { 0, 0 } } } translate Place }
#declare Place = <8 + 0.5, 0 + 0.5, 0>;
object { sphere { 0, 0.4 pigment { rgb <0.9, 0.6, 0.3> } bounded_by { sphere { 10, 1 } } } translate Place }
#declare Place = <9 + 0.5, 0 + 0.5, 0>;
object { sphere { 0, 0.4 inverse inverse pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
#declare Place = <9 + 0.5, 1 + 0.5, 0>;
object { cone { -0.4*y, -0.4, 0.3*y, -0.2 pigment { rgb <0.9, 0.6, 0.3> } } translate Place }
