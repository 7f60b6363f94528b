// Language 3.1: what filters in an upper layer lets light through instead, in every kind of pigment.
#version 3.1;
global_settings { assumed_gamma 1 }
camera { orthographic location <0,0,-5> look_at 0 right x*6 up y*4 }
#declare F = finish { ambient 1 diffuse 0 }
#macro Q(X,Y,T) box { <X,Y,0>,<X+0.9,Y+0.9,1> T } #end
#declare B = texture { pigment { rgb <1,0.5,0.2> } finish { F } }
#declare P = pigment { rgbf <0.2,0.3,0.8,0.3> }
#declare T1 = texture { pigment { rgbft <0.2,0.3,0.8,0.3,0.2> } finish { F } }
box { <-3,-2,0>,<-2.1,-1.1,1> texture { B } texture { T1 } }
box { <-2,-2,0>,<-1.1,-1.1,1> texture { B } texture { pigment { gradient x color_map { [0 rgbft <0.2,0.3,0.8,0.3,0.2>][1 rgbft <0.9,0.3,0.1,0.7,0.1>] } } finish { F } } }
box { <-1,-2,0>,<-0.1,-1.1,1> texture { B } texture { pigment { gradient x pigment_map { [0 rgbft <0.2,0.3,0.8,0.3,0.2>][1 rgbft <0.9,0.3,0.1,0.7,0.1>] } } finish { F } } }
box { <0,-2,0>,<0.9,-1.1,1> texture { B } texture { pigment { checker rgbft <0.2,0.3,0.8,0.3,0.2> rgbft <0.9,0.3,0.1,0.7,0.1> scale 0.2 } finish { F } } }
box { <1,-2,0>,<1.9,-1.1,1> texture { B } texture { pigment { checker pigment { rgbft <0.2,0.3,0.8,0.3,0.2> } pigment { rgbft <0.9,0.3,0.1,0.7,0.1> } scale 0.2 } finish { F } } }
#declare L = texture { pigment { rgbf <1,0.9,0.3,0.5> } finish { F } } texture { P finish { F } }
box { <2,-2,0>,<2.9,-1.1,1> texture { L } }
box { <-3,-1,0>,<-2.1,-0.1,1> texture { B } texture { L } }
box { <-2,-1,0>,<-1.1,-0.1,1> texture { pigment { rgbf <0.2,0.3,0.8,0.3> } finish { F } } }
box { <-1,-1,0>,<-0.1,-0.1,1> texture { B } texture { pigment { average pigment_map { [1 rgbf <0.2,0.3,0.8,0.3>][2 rgbft <0.9,0.3,0.1,0.7,0.1>] } } finish { F } } }
box { <0,-1,0>,<0.9,-0.1,1> texture { B } texture { pigment { image_map { png "rgba.png" filter all 0.3 } } finish { F } } }
box { <1,-1,0>,<1.9,-0.1,1> texture { B } texture { pigment { wood } finish { F } } texture { pigment { P } finish { F } } }
box { <2,-1,0>,<2.9,-0.1,1> texture { gradient x texture_map { [0 B][1 pigment { P } finish { F } ] } } }
plane { -z, -20 pigment { checker rgb 1 rgb 0.5 } finish { F } }
