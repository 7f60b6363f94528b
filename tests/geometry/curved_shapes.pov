// Rays against curved shapes, answered by durer and by povray.
#version 3.7; global_settings{assumed_gamma 1}
#include "rays.inc"
#declare M=transform{scale <1,2,.7> rotate <20,30,40> translate <1,2,3>}
#macro Moved_Point(V,T) #local F=function{transform{T}} #local W=V+<0,0,0>; #local R=F(W.x,W.y,W.z); (R) #end
#macro Both(Name,O,C,S,I)
  Rays(Name,O,C,S,I)
  Rays(concat(Name," moved"), object{O transform M}, Moved_Point(C,M), S*2, I)
#end
Both("blob",blob{threshold 0.5 sphere{-0.4*x,0.8,1} sphere{0.4*x,0.8,1} cylinder{-0.8*y,0.8*y,0.4,0.8} sphere{<.2,.3,-.4>,.5,-.6 scale <1,2,1>}},<0,0,0>,<1,1,1>,1)
Both("lathel",lathe{linear_spline 5,<0,-0.8>,<0.7,-0.6>,<0.3,0>,<0.7,0.6>,<0,0.8>},<0,0,0>,<.8,.8,.8>,1)
Both("latheq",lathe{quadratic_spline 5,<0,-0.8>,<0.7,-0.6>,<0.3,0>,<0.7,0.6>,<0,0.8>},<0,0,0>,<.8,.8,.8>,1)
Both("lathec",lathe{cubic_spline 7,<0.2,-1.2>,<0.4,-0.8>,<0.8,-0.3>,<0.4,0.2>,<0.5,0.6>,<0.1,0.8>,<0,1>},<0,0,0>,<.8,.8,.8>,1)
Both("latheb",lathe{bezier_spline 8,<.1,-.8>,<.9,-.8>,<.9,0>,<.4,0>,<.4,0>,<.1,.2>,<.7,.5>,<.2,.8>},<0,0,0>,<.8,.8,.8>,1)
Both("sor",sor{6,<0.2,-1.1>,<0.6,-0.8>,<0.3,-0.2>,<0.7,0.3>,<0.3,0.8>,<0,1>},<0,0,0>,<.8,.8,.8>,1)
Both("soro",sor{6,<0.2,-1.1>,<0.6,-0.8>,<0.3,-0.2>,<0.7,0.3>,<0.3,0.8>,<0,1> open sturm},<0,0,0>,<.8,.8,.8>,1)
Both("prisml",prism{linear_spline -0.5,0.5,6,<-0.8,-0.6>,<0.8,-0.6>,<0.3,0>,<0.8,0.7>,<-0.8,0.6>,<-0.8,-0.6>},<0,0,0>,<.9,.6,.9>,1)
Both("prismq",prism{quadratic_spline -0.5,0.5,7,<-1,0>,<0,-1>,<1,0>,<.5,.6>,<0,1>,<-1,.3>,<0,-1> open},<0,0,0>,<.9,.6,.9>,1)
Both("prismc",prism{cubic_spline -0.5,0.5,8,<-0.8,0>,<0,-0.8>,<0.8,0>,<0.4,0.5>,<0,0.8>,<-0.8,0.3>,<0,-0.8>,<0.8,0>},<0,0,0>,<.9,.6,.9>,1)
Both("prismb",prism{bezier_spline 0,1,8,<0,0>,<0.3,-1>,<0.7,-1>,<1,0>,<1,0>,<0.7,1>,<0.3,1>,<0,0>},<.5,.5,0>,<.6,.6,.9>,1)
Both("prismk",prism{conic_sweep linear_spline .2,1.2,5,<0.7,0.7>,<-0.7,0.7>,<-0.7,-0.7>,<0.7,-0.7>,<0.7,0.7>},<0,.7,0>,<.8,.6,.8>,1)
Both("prismkc",prism{conic_sweep cubic_spline .3,1.5,8,<-1,0>,<0,-1>,<1,0>,<.5,.6>,<0,1>,<-1,.3>,<0,-1>,<1,0> sturm},<0,.7,0>,<.8,.6,.8>,1)
Both("super",superellipsoid{<.4,.7>},<0,0,0>,<1,1,1>,1)
Both("super2",superellipsoid{<1.5,.3>},<0,0,0>,<1,1,1>,1)
Both("ovus",ovus{.75,.4},<0,.2,0>,<.8,1,.8>,1)
Both("ovus2",ovus{.5,.7},<0,.2,0>,<.8,1,.8>,1)
Both("quartic",quartic{<2,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,2,0,0,0,-1,0,0,0,0,0,2,0,-1,0,-0.5> sturm},<0,0,0>,<.8,.8,.8>,1)
Both("cubic",cubic{<1,.1,.2,.3,.4,.5,.6,-.7,.8,-.9,1,-.3,.2,.5,.1,.2,-.3,.4,.1,-.2>},<0,0,0>,<.8,.8,.8>,1)
Both("poly5",polynomial{5,xyz(5,0,0):1,xyz(0,2,1):-1,xyz(0,0,2):1,xyz(1,1,1):.5,xyz(0,0,0):-.2},<0,0,0>,<.8,.8,.8>,1)
Both("text",text{ttf "timrom.ttf" "R&8" 0.4,0},<.9,.3,.2>,<1,.5,.4>,1)
Both("bicubic",bicubic_patch{type 1 flatness 0 u_steps 4 v_steps 3 <-0.9,-0.9,0>,<-0.3,-0.9,0.5>,<0.3,-0.9,0>,<0.9,-0.9,0>,<-0.9,-0.3,0.4>,<-0.3,-0.3,-1.5>,<0.3,-0.3,0.6>,<0.9,-0.3,0>,<-0.9,0.3,0>,<-0.3,0.3,0.8>,<0.3,0.3,-1.2>,<0.9,0.3,0.3>,<-0.9,0.9,0>,<-0.3,0.9,0>,<0.3,0.9,0.5>,<0.9,0.9,0>},<0,0,0>,<.9,.9,.5>,0)
Both("iso",isosurface{function{x*x+y*y+z*z+0.3*sin(8*x)*sin(8*y)*sin(8*z)-0.6} contained_by{box{-0.9,0.9}} max_gradient 5 accuracy 0.0005},<0,0,0>,<.9,.9,.9>,1)
Both("isoall",isosurface{function{x*x+y*y+z*z+0.3*sin(8*x)*sin(8*y)*sin(8*z)-0.6} contained_by{sphere{0,0.7}} max_gradient 5 accuracy 0.0005 all_intersections},<0,0,0>,<.9,.9,.9>,1)
Both("para",parametric{function{sin(u)*cos(v)*(0.7+0.2*cos(3*v))},function{0.8*cos(u)},function{sin(u)*sin(v)*0.8} <0,0>,<pi,2*pi> contained_by{box{-1,1}} max_gradient 4 accuracy 0.002},<0,0,0>,<.9,.9,.9>,0)
