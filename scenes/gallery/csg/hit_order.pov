// Which of two coincident surfaces is seen: of equal depths the last member of a union or of an
// intersection, the first top-level object; cuts flush with a face, open and closed.
#version 3.7;
#include "stage.inc"
#declare R = texture { pigment { rgb <0.9, 0.2, 0.2> } }
#declare G = texture { pigment { rgb <0.2, 0.8, 0.3> } }
#declare B = texture { pigment { rgb <0.3, 0.4, 0.9> } }
union { box { -0.7, 0.7 texture { R } } box { -0.7, 0.7 texture { G } } split_union off translate <-2.6, 1.3, 0> }
intersection { box { -0.7, <0.7, 0.7, 0.9> texture { R } } box { -0.7, 0.7 texture { G } } translate <-0.8, 1.3, 0> }
box { <0.3, 0.6, -0.7>, <1.7, 2, 0.7> texture { R } }
box { <0.3, 0.6, -0.7>, <1.7, 2, 0.7> texture { G } }
difference { box { -0.7, 0.7 texture { R } } box { <-0.4, -0.4, -0.7>, <0.4, 0.4, 0> texture { G } } translate <2.8, 1.3, 0> }
difference { box { -0.7, 0.7 texture { R } } cylinder { -0.7*z, 0.5*z, 0.4 texture { B } } translate <-2.8, -1.3, 0> }
difference { box { -0.7, 0.7 texture { R } } cylinder { -0.7*z, 0.5*z, 0.4 open texture { B } } translate <-1, -1.3, 0> }
difference { box { -0.7, 0.7 texture { R } } box { -0.4, <0.4, 0.4, 0.5> texture { G } } box { -0.4, <0.4, 0.4, 0.5> texture { B } }
  box { <-0.2, -0.2, -1>, <0.2, 0.2, 0> } rotate -20*y translate <0.9, -1.3, 0> }
merge { box { -0.7, 0.7 texture { R } } box { <-0.7, -0.7, 0.2>, <0.7, 0.2, 1.2> texture { G } } rotate 15*y translate <2.8, -1.3, 0> }
box { <-5, -3, 2>, <5, 3, 2> texture { B } }
plane { z, 2 texture { G } hollow }
