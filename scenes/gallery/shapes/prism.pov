#version 3.7; global_settings{assumed_gamma 1}
camera{location <0,4,-9> look_at 0 angle 50}
light_source{<-5,8,-10>,1} light_source{<5,-2,-8>,.4}
#default{pigment{rgb<.9,.6,.3>} finish{ambient .1 phong .6}}
background{rgb<.1,.2,.3>}
prism{linear_spline 0,1,10,<-1,-1>,<1,-1>,<1,1>,<-1,1>,<-1,-1>,<-.5,-.5>,<.5,-.5>,<.5,.5>,<-.5,.5>,<-.5,-.5> translate<-3,1,0>}
prism{cubic_spline 0,.5,8,<-1,0>,<0,-1>,<1,0>,<.5,.6>,<0,1>,<-1,.3>,<0,-1>,<1,0> rotate -40*x translate<0,1.5,0> pigment{rgb<.4,.8,.4>}}
prism{quadratic_spline 0,1.5,7,<-1,0>,<0,-1>,<1,0>,<.5,.6>,<0,1>,<-1,.3>,<0,-1> open translate<3,1,0> pigment{rgb<.4,.5,.9>}}
prism{bezier_spline 0,1,8,<0,0>,<0.3,-1>,<0.7,-1>,<1,0>,<1,0>,<0.7,1>,<0.3,1>,<0,0> scale 1.5 rotate -30*x translate<-3.5,-2,0>}
prism{conic_sweep linear_spline 0,1,5,<1,1>,<-1,1>,<-1,-1>,<1,-1>,<1,1> rotate 180*x translate<-.3,-1,0>}
difference{prism{conic_sweep cubic_spline .3,1.5,8,<-1,0>,<0,-1>,<1,0>,<.5,.6>,<0,1>,<-1,.3>,<0,-1>,<1,0> sturm} box{<0,-1,-2>,<2,3,0>} translate<2.6,-2.5,0>}
