// Whose texture a surface has: children without one take the parent's, else the default;
// cutaway_textures lends them; interior_texture shows where the ray leaves.
#version 3.7;
#include "stage.inc"
#declare R = texture { pigment { rgb <0.9, 0.2, 0.2> } }
#declare G = texture { pigment { rgb <0.2, 0.8, 0.3> } }
#declare Knife = box { <-1, -1, -1>, <1, 1, 0> rotate <20, 30, 0> }
difference { sphere { 0, 0.9 texture { R } } object { Knife } translate <-2.6, 1.3, 0> }
difference { sphere { 0, 0.9 texture { R } } object { Knife } cutaway_textures translate <-0.8, 1.3, 0> }
difference { sphere { 0, 0.9 } object { Knife } texture { G } translate <1, 1.3, 0> }
difference { union { sphere { -0.3*x, 0.7 texture { R } } sphere { 0.3*x, 0.7 texture { G } } } object { Knife } cutaway_textures
  translate <2.8, 1.3, 0> }
intersection { sphere { 0, 0.9 texture { R } } box { -0.7, 0.7 texture { Squares } } object { Knife inverse } cutaway_textures
  translate <-2.7, -1.3, 0> }
sphere { 0, 0.9 texture { R } interior_texture { Squares } clipped_by { object { Knife inverse } } translate <-0.8, -1.3, 0> }
union { sphere { 0, 0.6 } difference { box { -0.8, 0.8 } cylinder { -z, z, 0.7 texture { R } } } texture { Squares }
  interior_texture { G } rotate <10, 20, 0> translate <1, -1.3, 0> }
#declare Old = object { sphere { 0, 0.9 } texture { Squares } }
object { Old texture { pigment { rgbt <0, 1, 0, 0.5> } } rotate 30*y translate <2.8, -1.3, 0> }
