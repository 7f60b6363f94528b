// Rays against sweeps and fields, answered by durer and by povray.
#version 3.7; global_settings{assumed_gamma 1}
#include "rays.inc"
#declare O=sphere_sweep{linear_spline 2,<0,0,0>,1,<2,0,0>,0.5}
Rays("lin2", O, <.8,0,0>, <2,1,1>, 1)
#declare O=sphere_sweep{linear_spline 4,<0,0,0>,.5,<2,0,0>,0.5,<2,2,0>,.3,<0,2,2>,.4}
Rays("lin4", O, <1,1,1>, <1.5,1.5,1.5>, 1)
Rays("lin4r", object{O rotate <30,20,10> scale -2}, <-2,-2,-2>, <4,4,4>, 1)
Rays("lin4s", object{O scale <1,2,3>}, <1,2,3>, <2,3,4>, 1)
#declare O=sphere_sweep{cubic_spline 4,<0,0,0>,0.3,<1,0,0>,0.3,<2,1,0>,0.3,<3,1,0>,0.3}
Rays("cub4", O, <1.5,.5,0>, <1,.8,.5>, 1)
#declare O=sphere_sweep{cubic_spline 7,<0,0,0>,0.3,<1,0,0>,0.6,<2,1,0>,0.3,<3,1,2>,0.3,<3,0,2>,.5,<2,-1,2>,.3,<1,-2,1>,.2 tolerance .01}
Rays("cub7", O, <1.5,.5,0>, <2,1.8,2.5>, 1)
#declare O=sphere_sweep{b_spline 7,<0,0,0>,0.3,<1,0,0>,0.6,<2,1,0>,0.3,<3,1,2>,0.3,<3,0,2>,.5,<2,-1,2>,.3,<1,-2,1>,.2}
Rays("b7", O, <1.5,.5,0>, <2,1.8,2.5>, 1)
Rays("b7m", object{O matrix<1,.5,0,0,1,0,0,.2,1,1,2,3>}, <2.5,2.5,3>, <2,1.8,2.5>, 1)
#declare O=sphere_sweep{linear_spline 2,<0,0,0>,1, <0.2,0,0>,2}
Rays("inner", O, <0,0,0>, <2,1.8,2.5>, 1)
#declare F=function{pattern{bozo scale .2}};
#declare O=height_field{function 12,9 {F(x,y,z)}}
Rays("hf", O, <.5,.3,.5>, <.5,.4,.5>, 1)
#declare O=height_field{function 12,9 {F(x,y,z)} smooth water_level .3}
Rays("hf smooth", O, <.5,.3,.5>, <.5,.4,.5>, 1)
#declare O=height_field{function 12,9 {F(x,y,z)} smooth scale <3,1,2> rotate <20,30,40>}
Rays("hf moved", O, <1.5,.3,1>, <1.5,1,1>, 1)
#declare O=height_field{png "plasma3.png"}
Rays("hf png", O, <.5,.3,.5>, <.5,.4,.5>, 1)
#declare O=height_field{png "plasma3.png" smooth}
Rays("hf png smooth", O, <.5,.3,.5>, <.5,.4,.5>, 1)
#declare O=height_field{pot "mtmand.pot" smooth}
Rays("hf pot", O, <.5,.3,.5>, <.5,.4,.5>, 1)
