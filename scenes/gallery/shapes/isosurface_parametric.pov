#version 3.7; global_settings{assumed_gamma 1}
#include "functions.inc"
camera{location <0,2,-9> look_at 0 angle 50}
light_source{<-5,8,-10>,1} light_source{<5,-2,-8>,.4}
#default{pigment{rgb<.9,.6,.3>} finish{ambient .1 phong .6}}
background{rgb<.1,.2,.3>}
isosurface{function{f_sphere(x,y,z,.8)+f_noise3d(x*5,y*5,z*5)*.3} max_gradient 3 contained_by{sphere{0,1.2}} translate<-3,1.3,0>}
isosurface{function{abs(x)+abs(y)+abs(z)-1.2} max_gradient 2 rotate 20*y translate<-.6,1.3,0> pigment{rgb<.4,.8,.4>}}
difference{isosurface{function{x*x+y*y+z*z-1} accuracy 1e-5 max_gradient 4 all_intersections} box{<0,0,-2>,2} translate<1.8,1.3,0> pigment{rgb<.4,.5,.9>}}
isosurface{function{sin(x*6)+sin(y*6)+cos(z*6)} open threshold .3 evaluate 1,1.2,.99 max_gradient 12 translate<-2.6,-1.4,0> scale <1,1,1.2>}
#declare f_lump=function{pattern{bozo scale .4}}
isosurface{function{f_lump(x,y,z)-.5} max_gradient 6 rotate<20,30,0> scale .9 translate<.3,-1.4,0>}
parametric{function{cos(u)*(1+.3*cos(v))},function{sin(u)*(1+.3*cos(v))},function{.3*sin(v)} <0,0>,<2*pi,2*pi> contained_by{box{<-1.4,-1.4,-.4>,<1.4,1.4,.4>}} max_gradient 1.5 accuracy .003 precompute 8,x,y,z rotate 50*x translate<2.8,-1.4,0> pigment{checker rgb 1 rgb<.7,0,0> scale .5} no_shadow}
