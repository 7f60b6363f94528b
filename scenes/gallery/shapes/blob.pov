#version 3.7; global_settings{assumed_gamma 1}
camera{location <0,2,-9> look_at 0 angle 50}
light_source{<-5,8,-10>,1} light_source{<5,-2,-8>,.4}
#default{pigment{rgb<.9,.6,.3>} finish{ambient .1 phong .6}}
background{rgb<.1,.2,.3>}
blob{threshold .6 sphere{-x*.4,1,1} sphere{x*.4,1,1} sphere{y*.8,.9,1.2} translate<-3,1,0>}
blob{threshold .3 cylinder{0,2*y,1,1} sphere{<.5,1,-.4>,.8,-1} translate<-.8,0.6,0> pigment{rgb<.4,.8,.4>}}
blob{threshold .2 sphere{-.2*x,1,1 pigment{rgb x}} sphere{.4*x,1,1 pigment{checker rgb 1 rgb 0 scale .2}} cylinder{<-1,-1,0>,<1,-1,0>,.5,1 scale<1,1,2>} translate<1.6,1,0>}
difference{blob{threshold .5 #declare i=0; #while(i<60) sphere{<sin(i*2.3),cos(i*1.7),sin(i*3.1+1)>*1.2,.7,1} #declare i=i+1; #end} box{<0,-2,-2>,<2,2,0>} translate<-2.6,-1.6,0>}
blob{threshold .5 sphere{0,1,2 scale<1.5,.5,1> rotate 30*z} sphere{<.3,.4,0>,1,.6} sturm translate<.4,-1.6,0> pigment{rgbf<.8,.9,1,.8>} interior{ior 1.3}}
blob{component 1,1,<0,0,0> component 1,1,<.6,.3,0> threshold .4 clipped_by{plane{z,0}} translate<3,-1.5,0>}
