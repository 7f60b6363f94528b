#version 3.7; global_settings{assumed_gamma 1}
camera{location <0,2,-9> look_at 0 angle 50}
light_source{<-5,8,-10>,1} light_source{<5,-2,-8>,.4}
#default{pigment{rgb<.9,.6,.3>} finish{ambient .1 phong .6}}
background{rgb<.1,.2,.3>}
ovus{1,.6 translate<-3,1,0>}
ovus{.6,1 uv_mapping pigment{checker rgb 1 rgb .2 scale .1} translate<-.8,1,0>}
difference{ovus{.7,.8 sturm} box{<-1,-2,-2>,<.2,1,0>} rotate<30,40,0> translate<1.6,1,0> pigment{rgb<.4,.5,.9>}}
ovus{.5,1 translate<3.4,.6,0>}
#declare P=bicubic_patch{type 1 flatness .01 u_steps 4 v_steps 4 <0,0,2>,<1,0,0>,<2,0,0>,<3,0,-2>,<0,1,0>,<1,1,-2>,<2,1,0>,<3,1,0>,<0,2,0>,<1,2,0>,<2,2,0>,<3,2,0>,<0,3,2>,<1,3,0>,<2,3,0>,<3,3,-2>}
object{P scale .7 rotate 20*y translate<-3.5,-3,0>}
bicubic_patch{type 0 flatness 0 u_steps 2 v_steps 1 uv_vectors <0,0>,<2,0>,<2,2>,<0,2> <0,0,2>,<1,0,0>,<2,0,0>,<3,0,-2>,<0,1,0>,<1,1,-2>,<2,1,0>,<3,1,0>,<0,2,0>,<1,2,0>,<2,2,0>,<3,2,0>,<0,3,2>,<1,3,0>,<2,3,0>,<3,3,-2> uv_mapping pigment{checker rgb 1 rgb<.7,0,0> scale .25} scale .7 rotate 20*y translate<-.8,-3,0>}
object{P scale .7 rotate 50*y clipped_by{sphere{<1,1,0>,1}} translate<1.8,-3,0>}
