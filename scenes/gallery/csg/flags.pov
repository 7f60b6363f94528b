// no_shadow, no_image, no_reflection on objects, on members of split and unsplit unions, merges and
// intersections; double_illuminate; a mirror behind shows who is reflected.
#version 3.7;
#include "stage.inc"
box { <-6, -2.2, 3>, <6, 4, 3.1> pigment { rgb 0.2 } finish { reflection 0.8 } }
plane { y, -2.2 pigment { checker rgb 0.9, rgb 0.6 } }
#declare R = texture { pigment { rgb <0.9, 0.2, 0.2> } }
#declare G = texture { pigment { rgb <0.2, 0.8, 0.3> } }
sphere { <-3, 1.2, 0>, 0.5 texture { R } no_shadow }
sphere { <-1.8, 1.2, 0>, 0.5 texture { R } no_image }
sphere { <-0.6, 1.2, 0>, 0.5 texture { R } no_reflection }
union { sphere { <0.6, 1.2, 0>, 0.4 texture { G } no_image } sphere { <1, 1.2, 0>, 0.4 texture { R } } }
union { sphere { <1.9, 1.2, 0>, 0.4 texture { G } no_image no_shadow } sphere { <2.3, 1.2, 0>, 0.4 texture { R } } split_union off }
merge { sphere { <3.1, 1.2, 0>, 0.4 texture { G } no_image } sphere { <3.5, 1.2, 0>, 0.4 texture { R } } }
intersection { sphere { <-3, -1, 0>, 0.6 texture { G } no_image } sphere { <-2.7, -1, 0>, 0.6 texture { R } no_reflection } }
union { sphere { <-1.4, -1, 0>, 0.4 no_shadow } box { <-1.2, -1.5, -0.3>, <-0.7, -0.7, 0.3> no_shadow } texture { G } split_union off }
triangle { <0, -1.6, 0.5>, <1, -1.6, 0.5>, <0.5, -0.3, 0.2> texture { G } }
triangle { <1.2, -1.6, 0.5>, <2.2, -1.6, 0.5>, <1.7, -0.3, 0.2> texture { G } double_illuminate }
union { sphere { <3, -1, 0>, 0.4 } sphere { <3.4, -1, 0>, 0.4 } texture { R } no_reflection }
light_source { <1, -1, 6>, rgb 0.6 }
