#include "colors.inc"
#include "shapes.inc"
#include "textures.inc"

#version 2.0
camera { location <0 3 -8> direction <0 0 1.5> up <0 1 0> right <1.3333 0 0> look_at <0 1 0> }
object { light_source { <5 10 -10> color White } }
#declare Pi2 = 6.28318
#declare N = 12
#declare Ring_Texture = texture { pigment { color red 0.9 green 0.7 blue 0.2 } finish { ambient 0.2 diffuse 0.7 phong 1 } }
union { sphere { <2 1 0> 0.4 } sphere { <1 1 1.73> 0.4 } sphere { <-1 1 1.73> 0.4 } sphere { <-2 1 0> 0.4 } texture { Ring_Texture } bounded_by { box { <-2.5 .5 -.5> <2.5 1.5 2.2> } } }
intersection { plane { y 1.5 } plane { -y 0 } plane { x 0.5 } plane { -x 0.5 } plane { z .5 } plane { -z .5 } texture { DMFWood4 scale 0.5 } }
plane { y 0 texture { pigment { checker color Gray80 color Gray40 } finish { reflection 0.2 } } }
quadric { <1 0 1> <0 0 0> <0 0 0>, -0.04 texture { Chrome_Texture } clipped_by { plane { y 4 } } }
object { Cone_Y scale <.5 .8 .5> translate <-2 0 -1.5> texture { pigment { color Cyan } } }
sphere { <1.5 .6 -2> .6 texture { Glass } }
