#version 3.6;
#include "transforms.inc"
#default{texture{pigment{color rgb <0.8,0.8,0.8>} finish{ambient 0.000 diffuse 0.650 phong 0.1 phong_size 40.0 specular 0.5}}}
#declare VMD_width=160; #declare VMD_height=120;
#macro VMD_triangle (P1, P2, P3, N1, N2, N3, C1)
  smooth_triangle { P1, N1, P2, N2, P3, N3 texture { pigment { C1 } } }
#end
#macro VMDC(C1) texture { pigment { C1 }} #end
#macro VMD_sphere (P1, R1, C1) sphere {P1, R1 VMDC(C1)} #end
#macro VMD_cylinder (P1, P2, R1, C1, O1)
  cylinder {P1, P2, R1 #if(O1) open #end VMDC(C1)}
#end
#macro VMD_cone (P1, P2, R1, C1) cone { P1, R1, P2, 0 VMDC(C1) } #end
#macro VMD_tritext (P, N) #local r = vlength(P); texture{pigment{color rgbt <r/2,0.2,1-r/2,0.1>}} #end
camera { orthographic up <0, 3.0, 0> right <4.0, 0, 0> location <0,0,-4> look_at <0,0,0> direction <0,0,4> }
light_source { <-0.1,0.1,-1>*100 color rgb <1,1,1> parallel point_at <0,0,0> }
background { color rgb <0,0,0> }
fog { distance 8 fog_type 1 color rgb <0,0,0> }
VMD_sphere(<-1,0,0>, 0.5, rgbt<1,0,0,0>)
VMD_cylinder(<-1,0,0>, <1,0.5,0>, 0.2, rgbt<0.2,0.9,0.3,0.0>, 1)
VMD_cone(<1,0.5,0>, <1.6,0.9,0>, 0.35, rgbt<0,0,1,0.3>)
union { VMD_triangle(<0,-1,0>,<1,-1,0>,<0.5,-0.2,0>, <0,0.3,-1>,<0.3,0,-1>,<0,0,-1>, rgbt<1,1,0,0>)
 VMD_triangle(<0,-1,0>,<-1,-1,0>,<-0.5,-0.2,0>, <0,0.3,-1>,<0.3,0,-1>,<0,0,-1>, rgbt<1,0,1,0>) }
object { sphere { 0, 0.3 VMD_tritext(<1,0,0>, y) } Rotate_Around_Trans(<0,30,0>, <1,0,0>) translate y }
