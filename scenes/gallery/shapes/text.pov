#version 3.7; global_settings{assumed_gamma 1}
camera{location <0,1,-9> look_at 0 angle 50}
light_source{<-5,8,-10>,1} light_source{<5,-2,-8>,.4}
#default{pigment{rgb<.9,.6,.3>} finish{ambient .1 phong .6}}
background{rgb<.1,.2,.3>}
text{ttf "timrom.ttf" "AVo Toy&8%" .3,0 translate<-3.5,1.5,0>}
text{ttf "cyrvetic.ttf" "Dürer @ij" 1,<.1,.05,0> rotate<-20,25,0> translate<-3.5,.2,0> pigment{rgb<.4,.8,.4>}}
difference{box{<-.2,-.4,.1>,<6,1,.6>} text{ttf "crystal.ttf" "Crystal g" 1,0 translate -z*.5}  translate<-3.5,-1.6,0> pigment{rgb<.4,.5,.9>}}
text{internal 0 "A" .5,0 scale 1.5 rotate 40*y translate<2.4,0,0>}
text{internal 1 "Rß" .5,0 scale 1.5 rotate -40*y translate<2.4,1,0>}
