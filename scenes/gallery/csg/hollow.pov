// Fog, hollow and solid members of a CSG, glass within glass, the camera inside a hollow box.
#version 3.7;
#include "stage.inc"
fog { distance 25 color rgb <0.6, 0.7, 0.8> }
box { -30, 30 pigment { rgb <0.5, 0.6, 0.5> } hollow }
sphere { <-2.6, 1, 0>, 0.9 texture { Glass } interior { ior 1.4 } }
sphere { <-0.7, 1, 0>, 0.9 texture { Glass } interior { ior 1.4 } hollow }
union { sphere { 0, 0.9 } sphere { 0.5*y, 0.5 hollow } texture { Glass } interior { ior 1.2 } translate <1.1, 1, 0> }
merge { sphere { 0, 0.7 } box { <-0.3, -0.3, -0.9>, <0.6, 0.9, 0.3> } texture { Glass } interior { ior 1.3 } hollow translate <2.9, 1, 0> }
difference { sphere { 0, 0.9 } sphere { 0, 0.7 } texture { Glass } interior { ior 1.5 } translate <-2.6, -1.3, 0> }
sphere { <-0.7, -1.3, 0>, 0.9 texture { Glass } interior { ior 1.5 } }
sphere { <-0.7, -1.3, 0>, 0.5 pigment { rgbf <1, 0.6, 0.6, 0.8> } interior { ior 1.1 } }
object { union { cylinder { -0.8*y, 0.8*y, 0.5 } sphere { 0.5*x, 0.5 } } texture { Glass } interior { ior 1.33 } split_union off translate <1.1, -1.3, 0> }
cone { <2.9, -2, 0>, 0.8, <2.9, -0.4, 0>, 0.2 texture { Glass } interior { ior 1.3 } hollow off }
