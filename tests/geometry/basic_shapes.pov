// Rays against basic shapes, answered by durer and by povray.
#version 3.7; global_settings{assumed_gamma 1}
#include "rays.inc"
#declare M=transform{scale <1,2,.7> rotate <20,30,40> translate <1,2,3>}
#macro Both(Name,O,C,S,I)
  Rays(Name,O,C,S,I)
  Rays(concat(Name," moved"), object{O transform M}, vtransform(C,M), S*2, I)
#end
#macro vtransform(V,T) #local F=function{transform{T}} #local R=F(V.x,V.y,V.z); (R) #end
Both("sphere",object{sphere{<1,0,0>,1}},<1,0,0>,<1,1,1>,1)
Rays("sphere uni",object{sphere{<1,0,0>,1} scale 2 rotate 30*y},<1.7,0,-1>,<2,2,2>,1)
Both("box",object{box{<-1,0,0>,<1,1,2>}},<0,.5,1>,<1,.5,1>,1)
Both("cyl",object{cylinder{0,<1,1,0>,.5}},<.5,.5,0>,<1,1,1>,1)
Both("cylo",object{cylinder{0,<1,1,0>,.5 open}},<.5,.5,0>,<1,1,1>,1)
Both("cone",object{cone{0,.5,<1,1,0>,.2}},<.5,.5,0>,<1,1,1>,1)
Both("cone2",object{cone{0,0,<1,1,0>,.7 open}},<.5,.5,0>,<1,1,1>,1)
Both("cone3",object{cone{0,1,2*y,-1}},<0,1,0>,<1,1,1>,1)
Both("cone4",object{cone{0,1,2*y,1}},<0,1,0>,<1,1,1>,1)
Both("plane",object{plane{<1,2,3>,.3}},<0,0,0>,<1,1,1>,1)
Both("disc",object{disc{<0,0,0>,<1,2,3>,1,.3}},<0,0,0>,<1,1,1>,1)
Both("torus",object{torus{1,.3}},<0,0,0>,<1.4,.4,1.4>,1)
Both("torus sturm",object{torus{1,.3 sturm}},<0,0,0>,<1.4,.4,1.4>,1)
Both("spindle",object{torus{.5,1}},<0,0,0>,<1.4,1,1.4>,1)
Both("triangle",object{triangle{0,x,<0,1,.3>}},<.3,.3,.1>,<.3,.3,.2>,0)
Both("triangle2",object{triangle{0,y,<1,0,.3>}},<.3,.3,.1>,<.3,.3,.2>,0)
Both("smooth",object{smooth_triangle{0,<0,0,1>,x,<.3,0,1>,<0,1,.3>,<0,.4,1>}},<.3,.3,.1>,<.3,.3,.2>,0)
Both("polygon",object{polygon{10,<0,0,0>,<1,0,0>,<1,1,0>,<0,1,0>,<0,0,0>,<.3,.3,0>,<.6,.3,0>,<.6,.6,0>,<.3,.6,0>,<.3,.3,0>}},<.5,.5,0>,<.6,.6,.3>,1)
Both("mesh",mesh{triangle{0,x,<0,1,.3>} smooth_triangle{x,<0,0,1>,y,<0,.3,1>,<1,1,1>,<.3,0,1>}},<.5,.5,.2>,<.5,.5,.5>,0)
#declare T=mesh2{vertex_vectors{4,<0,0,0>,<1,0,0>,<0,1,0>,<0,0,1>} face_indices{4,<0,1,2>,<0,1,3>,<0,2,3>,<1,2,3>} inside_vector <.3,.5,.7>}
Both("mesh2",T,<.3,.3,.3>,<.5,.5,.5>,1)
Both("mesh2 s",mesh2{vertex_vectors{4,<0,0,0>,<1,0,0>,<0,1,0>,<0,0,1>} normal_vectors{4,<-1,-1,-1>,<1,0,0>,<0,1,0>,<0,0,1>} face_indices{4,<0,1,2>,<0,1,3>,<0,2,3>,<1,2,3>}},<.3,.3,.3>,<.5,.5,.5>,0)
Both("quadric",object{quadric{<1,.5,.7>,<.1,.2,.3>,<.1,-1,.2>,-.5}},<0,0,0>,<1.4,1.4,1.4>,1)
Both("parab",object{quadric{<1,0,1>,<0,0,0>,<0,-1,0>,0 clipped_by{box{-1,1}}}},<0,.5,0>,<1,.5,1>,1)
