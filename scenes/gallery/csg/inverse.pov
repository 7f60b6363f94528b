// Inverted primitives and CSG, twice inverted unions, difference of differences, intersections with
// patches and discs, infinite solids.
#version 3.7;
#include "stage.inc"
#declare R = texture { pigment { rgb <0.9, 0.2, 0.2> } }
#declare U = union { sphere { -0.3*x, 0.6 } sphere { 0.3*x, 0.6 } }
intersection { box { -0.8, 0.8 texture { R } } object { U inverse texture { Squares } } box { <-1, -1, 0>, <1, 1, -1> inverse } translate <-2.7, 1.3, 0> }
object { object { U inverse } inverse texture { Glass } translate <-0.9, 1.3, 0> }
difference { box { -0.8, 0.8 } difference { sphere { -0.5*z, 0.9 } cylinder { -2*z, 2*z, 0.3 } texture { R } } texture { Squares } translate <0.9, 1.3, 0> }
difference { sphere { 0, 0.8 } plane { z, -0.3 texture { R } } plane { -x, -0.4 } texture { Squares } translate <2.7, 1.3, 0> }
intersection { sphere { 0, 0.8 } disc { 0, <0.3, 0.2, 1>, 0.6 texture { R } } texture { Squares } translate <-2.7, -1.3, 0> }
intersection { box { -0.7, 0.7 } quadric { <1, 0, 1>, <0, 0, 0>, <0, -1, 0>, 0 inverse } texture { R } rotate <-20, 20, 0> translate <-0.9, -1.3, 0> }
difference { sphere { 0, 0.8 } merge { box { <0, 0, -1>, <1, 1, 1> } box { <-1, -1, -1>, <0.2, 0.2, -0.4> } inverse } texture { R } translate <0.9, -1.3, 0> }
intersection { object { U } plane { x, 0.4 rotate 30*z } plane { -y, 0.3 } plane { z, 0.2 inverse } plane { z, 0.5 } texture { Squares } translate <2.7, -1.3, 0> }
