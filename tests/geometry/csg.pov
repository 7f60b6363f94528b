// Rays against csg, answered by durer and by povray.
#version 3.7; global_settings{assumed_gamma 1}
#include "rays.inc"
#declare A=sphere{<.3,0,0>,.8}
#declare B=box{-.6,.6}
#declare C=cylinder{-y,y,.4}
#declare U=union{object{A} object{B}}
Rays("union",U,0,<1,1,1>,1)
Rays("merge",merge{object{A} object{B} object{C}},0,<1,1,1>,1)
Rays("inter",intersection{object{A} object{B}},0,<1,1,1>,1)
Rays("diff",difference{object{B} object{C} object{A translate .5}},0,<1,1,1>,1)
Rays("nested",difference{merge{object{B} object{C}} intersection{object{A} object{B translate .3}} object{C rotate 90*x}},0,<1,1,1>,1)
Rays("inv",object{U inverse},0,<1,1,1>,1)
Rays("invinv",object{object{U inverse} inverse},0,<1,1,1>,1)
Rays("clip",object{A clipped_by{object{B} plane{y,.2}}},0,<1,1,1>,1)
Rays("clipu",union{object{A} object{B} clipped_by{object{C}}},0,<1,1,1>,1)
Rays("clipinv",object{B clipped_by{object{A inverse}}},0,<1,1,1>,1)
Rays("bound",union{object{A} object{B} bounded_by{sphere{0,.7}}},0,<1,1,1>,1)
Rays("boundclip",object{A bounded_by{box{-.5,.5}} clipped_by{bounded_by}},0,<1,1,1>,1)
Rays("planes",intersection{plane{x,.5} plane{-x,.5} plane{y,.5 rotate 20*z} plane{-y,.5} plane{z,.5} plane{-z,.5}},0,<1,1,1>,1)
Rays("moved",object{difference{object{B} object{C}} rotate <20,30,40> scale <1,2,.5> translate <1,2,3> rotate 50*x},vrotate(<1,2,3>,50*x),<2,2,2>,1)
Rays("invd",object{difference{object{B} object{C}} inverse},0,<1,1,1>,1)
Rays("quadric",intersection{quadric{<1,1,-1>,<0,0,0>,<0,0,0>,-.3} box{-1,1}},0,<1,1,1>,1)
Rays("julia",difference{box{-1,1} julia_fractal{<-0.083,0.0,-0.83,-0.025> max_iteration 8 precision 15}},0,<1,1,1>,1)
Rays("disc",intersection{object{A} disc{0,<1,1,1>,.5}},0,<1,1,1>,1)
Rays("discd",difference{object{A} disc{0,<1,1,1>,.5}},0,<1,1,1>,1)
Rays("hf",difference{object{B} height_field{function 12,9 {pattern{bozo scale .3}} translate -.5 scale 1.6}},0,<1,1,1>,1)
Rays("looks",light_source{<.1,.2,.3>,1 looks_like{sphere{0,.5}}},0,<1,1,1>,0)
