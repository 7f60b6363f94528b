#include "colors.inc"
#include "finish.inc"

global_settings {assumed_gamma 1 max_trace_level 6}
background {color White transmit 1.0}
camera {orthographic
  right -12.33*x up 9.01*y
  direction 1.00*z
  location <0,0,50.00> look_at <0,0,0>}


light_source {<  2.00,   3.00,  40.00> color White
  area_light <0.70, 0, 0>, <0, 0.70, 0>, 3, 3
  adaptive 1 jitter}
// no fog
#declare simple = finish {phong 0.7}
#declare pale = finish {ambient 0.5 diffuse 0.85 roughness 0.001 specular 0.200 }
#declare intermediate = finish {ambient 0.3 diffuse 0.6 specular 0.1 roughness 0.04}
#declare vmd = finish {ambient 0.0 diffuse 0.65 phong 0.1 phong_size 40.0 specular 0.5 }
#declare jmol = finish {ambient 0.2 diffuse 0.6 specular 1 roughness 0.001 metallic}
#declare ase2 = finish {ambient 0.05 brilliance 3 diffuse 0.6 metallic specular 0.7 roughness 0.04 reflection 0.15}
#declare ase3 = finish {ambient 0.15 brilliance 2 diffuse 0.6 metallic specular 1.0 roughness 0.001 reflection 0.0}
#declare glass = finish {ambient 0.05 diffuse 0.3 specular 1.0 roughness 0.001}
#declare glass2 = finish {ambient 0.01 diffuse 0.3 specular 1.0 reflection 0.25 roughness 0.001}
#declare Rcell = 0.050;
#declare Rbond = 0.100;

#macro atom(LOC, R, COL, TRANS, FIN)
  sphere{LOC, R texture{pigment{color COL transmit TRANS} finish{FIN}}}
#end
#macro constrain(LOC, R, COL, TRANS FIN)
union{torus{R, Rcell rotate 45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
     torus{R, Rcell rotate -45*z texture{pigment{color COL transmit TRANS} finish{FIN}}}
     translate LOC}
#end

cylinder {< -4.10,  -3.16, -10.92>, <  4.10,  -3.16, -10.92>, Rcell pigment {Black}}
cylinder {< -4.10,   3.16, -10.92>, <  4.10,   3.16, -10.92>, Rcell pigment {Black}}
atom(< -1.10,  -1.16,  -1.92>, 1.11, rgb <0.87, 0.60, 0.40>, 0.0, ase2) // #0
atom(<  0.55,   0.30,  -2.77>, 1.36, rgb <1.00, 0.05, 0.05>, 0.0, glass) // #1
atom(<  2.10,   1.16,  -1.12>, 0.70, rgb <0.30, 0.40, 0.90>, 0.3, jmol) // #2
atom(<  2.90,  -1.76,  -0.92>, 0.31, rgb <1.00, 1.00, 1.00>, 0.0, pale) // #3
constrain(<2.9,-1.76,-.92>, 0.31, Black, 0.0 ase3)
cylinder {<0,0,0>, <2,1,-1>, Rbond texture{pigment {color rgb <0.87, 0.60, 0.40> transmit 0.0} finish{ase3}}}
