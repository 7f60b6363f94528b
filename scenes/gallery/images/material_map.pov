// material_map by palette index and by red; more and fewer textures than indices.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "panels.inc"
#macro T(C) texture { pigment { C } finish { ambient 0.8 diffuse 0.2 } } #end
#macro Six() T(pigment { color rgb x }) T(pigment { color rgb y }) T(pigment { color rgb z }) T(pigment { checker rgb 0 rgb 1 scale 0.1 }) T(pigment { gradient x }) T(pigment { color rgbt 0.7 }) #end
#macro MP(I, S)
  box { 0, <1, 1, 0.01> texture { I scale <0.94*S, 0.94*S, 1> } translate <mod(Panel_Number, 5), 3 - div(Panel_Number, 5), 0> }
  #declare Panel_Number = Panel_Number + 1;
#end
MP(texture { material_map { png "palette.png" Six() } }, 1)
MP(texture { material_map { gif "palette.gif" Six() } }, 1)
MP(texture { material_map { png "palette4.png" T(pigment { color rgb x }) T(pigment { color rgb y }) } }, 1)
MP(texture { material_map { png "palette.png" T(pigment { color rgb x }) T(pigment { color rgb y }) T(pigment { color rgb z }) } }, 1)
MP(texture { material_map { png "palette.png" T(pigment { color rgb x }) T(pigment { color rgb y }) T(pigment { color rgb z }) T(pigment { color rgb 1 }) } }, 1)
MP(texture { material_map { png "rgb.png" Six() } }, 1)
MP(texture { material_map { png "grey.png" Six() } }, 1)
MP(texture { material_map { png "palette.png" interpolate 2 Six() } }, 2)
MP(texture { material_map { png "palette.png" once Six() } }, 0.5)
MP(texture { material_map { ppm "rgb.ppm" map_type 1 Six() } translate <0.5, 0.5, 0.3> }, 1)
MP(texture { material_map { tga "rgb.tga" Six() } rotate 20*z }, 1)
MP(texture { material_map { png "palette.png" T(pigment { color rgb x }) } }, 1)
MP(texture { material_map { png "rgb16.png" Six() } }, 1)
MP(texture { material_map { png "palette_alpha.png" Six() } }, 0.7)
MP(texture { material_map { gif "palette.gif" interpolate 4 repeat <2, 2> Six() } }, 1)
