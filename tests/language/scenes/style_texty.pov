#version 3.7;
global_settings { assumed_gamma 1 }
#include "strings.inc"
#include "arrays.inc"
#include "math.inc"
#declare Words = array[6] { "Albrecht", "Durer", "1525", "lute", "strings", "frame" }
#declare Data = array[3][4] { { 1, 2.5, 3, 2 }, { 2, 1.5, 0.5, 3 }, { 3, 2, 1, 0.5 } }
#macro Reverse(S) #local T = ""; #for (I, strlen(S), 1, -1) #local T = concat(T, substr(S, I, 1)); #end T #end
#for (I, 0, dimension_size(Words, 1) - 1)
  #declare W = Words[I];
  #debug concat(W, " -> ", strupr(W), " ", Reverse(W), " ", str(strlen(W), 3, 0), "\n")
  text { ttf "timrom.ttf" W 0.2, 0 pigment { rgb <mod(I, 2), 0.5, 1 - I / 6> } scale 0.7 translate <-3.5 + 3 * mod(I, 2), 2.4 - I * 0.7, 0> }
#end
#for (I, 0, 2)
  #for (J, 0, 3)
    box { <0, 0, 0>, <0.4, Data[I][J] * 0.6, 0.4> translate <1 + J * 0.6, -2.2, I * 0.6> pigment { rgb <I / 2, J / 3, 0.5> } }
    #debug concat(str(Data[I][J], 6, 2), #if (J < 3) "," #else "\n" #end)
  #end
#end
#debug concat(vstr(3,<1,2,3>,",",0,1), " ", CRGBStr(rgb <0.1,0.2,0.3>, 0, 2), "\n")
#debug concat(Parse_String("\"parsed\""), "\n")
camera { location <0.3, 0.3, -9> look_at <0.3, 0, 0> angle 45 }
light_source { <5, 8, -10>, 1 }
background { rgb 0.1 }
