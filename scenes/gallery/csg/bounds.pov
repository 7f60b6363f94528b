// bounded_by and clipped_by: right and wrong bounds, shared lists, clips of clips, CSG as clip,
// inverted clips, bounds of members, quadrics and planes that get their box from a clip.
#version 3.7;
#include "stage.inc"
#declare R = texture { pigment { rgb <0.9, 0.2, 0.2> } }
sphere { 0, 0.9 texture { R } clipped_by { box { <-0.6, -2, -2>, <0.6, 2, 2> } } bounded_by { clipped_by } translate <-2.7, 1.3, 0> }
torus { 0.6, 0.3 rotate 60*x bounded_by { sphere { 0.3*x, 0.6 } } translate <-0.9, 1.3, 0> }
union { sphere { 0, 0.7 } box { <0, 0, -1>, <0.8, 0.8, 1> } bounded_by { box { <-0.8, -0.8, -0.5>, <0.6, 0.6, 0.5> } } split_union off
  texture { Squares } translate <0.9, 1.3, 0> }
quadric { <1, 0, 1>, <0, 0, 0>, <0, -1, 0>, 0 clipped_by { plane { y, 1.2 } } texture { R } rotate -20*x translate <2.7, 0.7, 0> }
difference {
  sphere { 0, 0.9 clipped_by { plane { x, 0.5 clipped_by { plane { y, 0.5 } } } } }
  cylinder { -z, z, 0.3 clipped_by { plane { z, 0 } } }
  texture { Squares } translate <-2.7, -1.3, 0>
}
box { -0.7, 0.7 clipped_by { difference { sphere { 0, 0.95 } cylinder { -2*x, 2*x, 0.4 } } } texture { R } rotate <20, 30, 0> translate <-0.9, -1.3, 0> }
sphere { 0, 0.9 clipped_by { sphere { <0.3, 0.3, -0.7>, 0.6 inverse } } texture { R } interior_texture { Squares } translate <0.9, -1.3, 0> }
intersection { quadric { <1, 1, -1>, <0, 0, 0>, <0, 0, 0>, -0.3 } plane { z, 0.8 } plane { -z, 0.8 } texture { R }
  scale 0.6 rotate <20, 50, 0> translate <2.7, -1.3, 0> }
