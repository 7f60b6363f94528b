#include "colors.inc"
#include "shapes.inc"
#include "textures.inc"
#version 3.0
camera { location <0, 2, -6> direction <0, 0, 1.5> up y right <1.33, 0, 0> look_at <0, 0.5, 0> }
object { light_source { <10, 20, -15> colour White } }
light_source { <-8, 5, -10> color red 0.4 green 0.4 blue 0.6 }
plane { y, 0 pigment { checker color Wheat color Brown scale 0.7 } finish { reflection 0.1 ambient 0.2 } }
#declare Ball = sphere { <0,1,0>, 1 }
#declare T1 = texture { pigment { marble turbulence 0.8 color_map { [0.0 0.4 color Red color Orange] [0.4 0.8 color Orange color Yellow] [0.8 1.01 color Yellow color Red] } } finish { phong 0.8 phong_size 60 } }
#declare I = 0
#while (I < 5)
  object { Ball scale 0.3 + I * 0.08 translate <I * 1.1 - 2.4, 0, 1 - I * 0.3> texture { T1 rotate z * 30 * I scale 0.5 } }
  #declare I = I + 1
#end
#switch (I)
 #case (5) box { <-3, 0, 2>, <-2, 2, 3> pigment { Jade } } #break
 #case (6) box { 0, 1 }
#end
intersection { object { Cube } object { Ball translate -y scale 1.25 } translate <2.5, 1, 2> pigment { color CadetBlue } finish { Shiny } }
fog { color rgb <0.7,0.8,0.9> distance 60 }
#if (version < 3.5) union { sphere { <0.2,0.3,-2>, 0.3 } torus { 0.4, 0.1 translate <-0.6, 0.1, -2> } texture { Gold_Texture } } #end
