#version 3.7; global_settings{assumed_gamma 1}
camera{location <0,2,-9> look_at 0 angle 50}
light_source{<-5,8,-10>,1} light_source{<5,-2,-8>,.4}
#default{pigment{rgb<.9,.6,.3>} finish{ambient .1 phong .6}}
background{rgb<.1,.2,.3>}
superellipsoid{<.25,.25> rotate 30*y translate<-3,1.5,0>}
superellipsoid{<3,.5> rotate 30*y translate<-.8,1.5,0> pigment{rgb<.4,.8,.4>}}
difference{superellipsoid{<1,.2>} sphere{<0,0,-1>,.8} rotate<30,40,0> translate<1.6,1.5,0> pigment{rgb<.4,.5,.9>}}
superellipsoid{<1.7,2.4> scale<1,.5,1.3> rotate<30,40,0> translate<3.6,1.5,0>}
quartic{<1,0,0,0,2,0,0,2,0,-1.04,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,-1.04,0,0,0,0,1,0,.96,0,.2304> scale .8 rotate 60*x translate<-3,-1,0> bounded_by{sphere{<-3,-1,0>,2}}}
intersection{cubic{<0,0,0,0,1,0,0,0,0,0,0,0,0,0,0,0,-1,0,0,0> } sphere{0,1.2} translate<-.7,-1,0> pigment{rgb<.4,.8,.4>}}
poly{2,<1,0,0,-.2,1,0,0,1,0,-.5> translate<3.4,-1,0> pigment{checker rgb 1 rgb .2 scale .3}}
