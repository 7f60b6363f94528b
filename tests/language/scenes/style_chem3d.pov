// Molecule export
#version 3.1;
global_settings { assumed_gamma 2.2 }
#declare Fin = finish { ambient 0.25 diffuse 0.65 phong 0.6 phong_size 35 }
#declare C_Tex = texture { pigment { color rgb <0.35,0.35,0.35> } finish { Fin } }
#declare O_Tex = texture { pigment { color rgb <0.9,0.1,0.1> } finish { Fin } }
#declare H_Tex = texture { pigment { color rgbt <0.95,0.95,0.95,0.0> } finish { Fin } }
#macro Atom(X,Y,Z,R,T) sphere { <X,Y,Z>, R texture { T } } #end
#macro Bond(A,B,TA,TB)
  #local M = (A+B)/2
  cylinder { A, M, 0.12 texture { TA } }
  cylinder { M, B, 0.12 texture { TB } }
#end
camera { location <0,0,-8> right <4/3,0,0> up <0,1,0> direction <0,0,2> look_at <0,0,0> }
light_source { <10,10,-20> color rgb <1,1,1> }
light_source { <-20,5,-10> color rgb 0.3 shadowless }
background { color rgb <0.05,0.05,0.15> }
union {
  Atom(0,0,0,0.4,C_Tex)
  Atom(1.2,0.3,0,0.35,O_Tex)
  Atom(-0.6,0.9,0.2,0.25,H_Tex)
  Atom(-0.6,-0.9,-0.2,0.25,H_Tex)
  Bond(<0,0,0>,<1.2,0.3,0>,C_Tex,O_Tex)
  Bond(<0,0,0>,<-0.6,0.9,0.2>,C_Tex,H_Tex)
  Bond(<0,0,0>,<-0.6,-0.9,-0.2>,C_Tex,H_Tex)
  rotate <10,-20,5>
}
union { blob { threshold 0.5 sphere { <0,0,0> 1 strength 1 } sphere { <1.2,0.3,0> 0.9 strength 1 } texture { pigment { color rgbt <0.3,0.6,1,0.7> } finish { phong 1 } } } translate <1.5,-1.2,0> scale 0.8 }
