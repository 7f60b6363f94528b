#version 3.7; global_settings{assumed_gamma 1}
camera{location <0,2,-9> look_at 0 angle 50}
light_source{<-5,8,-10>,1} light_source{<5,-2,-8>,.4}
#default{pigment{rgb<.9,.6,.3>} finish{ambient .1 phong .6}}
background{rgb<.1,.2,.3>}
lathe{linear_spline 5,<0,0>,<1,0>,<.5,.5>,<1,1>,<.4,1.4> translate<-3,1.2,0> pigment{rgb<1,.3,.3>}}
lathe{quadratic_spline 5,<.5,-.2><1,0>,<.5,.5>,<1,1>,<.4,1.4> rotate 30*x translate<-1,1.2,0>}
lathe{cubic_spline 6,<.5,-.2><1,0>,<.5,.5>,<1,1>,<.4,1.4>,<0,2> scale <1,.8,1.5> rotate 20*z translate<1.3,1.2,0>}
difference{lathe{bezier_spline 8,<0,0>,<1,.1>,<1,1>,<.5,1>,<.5,1>,<.3,1>,<.4,1.5>,<0,1.6> sturm} box{<0,-.1,-2>,<2,.7,-.2>} pigment{checker rgb 1 rgb .3 scale .2} translate<3.2,1.2,0>}
sor{6,<.2,-.5>,<.6,0>,<1,.5>,<.5,1>,<.8,1.5>,<.3,2> translate<-3,-2,0> uv_mapping pigment{gradient y frequency 8}}
sor{6,<.2,-.5>,<.6,0>,<1,.5>,<.5,1>,<.8,1.5>,<.3,2> open rotate 50*x translate<-.8,-1.6,0>}
difference{sor{6,<.2,-.5>,<.6,0>,<1,.5>,<.5,1>,<.8,1.5>,<.3,2>} box{<0,-1,-2>,<2,3,0>} scale<1,.7,1> translate<1.2,-2,0>}
