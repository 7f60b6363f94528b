// What starts from #default and what does not: function{ pigment{} } and pigment_pattern start anew.
#version 3.7; global_settings { assumed_gamma 1 }
#include "functions.inc"
#default { texture { pigment { bozo phase 0.3 frequency 2 colour_map { [0 rgb <0.75,0.79,0.52>] [1 rgb <0.51,0.26,0.43>] } turbulence .3 scale .5 } normal { bumps .4 phase .2 frequency 2 scale .3 } } }
camera { orthographic location -8*z look_at 0 right 8*x up 6*y direction z normal { ripples .1 } }
light_source { <-7,5,-6> rgb 1 }
background { rgb <.2,.4,.6> }
#declare P = pigment { gradient y };
#declare F = function { pigment { gradient x } }
sphere { <-3,2,0>,.9 pigment { P } }
sphere { <-1,2,0>,.9 pigment { function { F(x,y,z).red } } }
sphere { <1,2,0>,.9 pigment { pigment_pattern { gradient x } } }
sphere { <3,2,0>,.9 texture { material_map { png "pal.png" texture { pigment { gradient x } } texture { pigment { P } normal { ripples } } } } }
sphere { <-3,0,0>,.9 texture { checker texture { pigment { gradient x } } texture { normal { dents 1 } } } }
sphere { <-1,0,0>,.9 texture { gradient x texture_map { [0 pigment { gradient y } ] [1 normal { ripples 1 } ] } } }
sphere { <1,0,0>,.9 normal { gradient x normal_map { [0 ripples 1 ] [1 wrinkles 1] } } }
sphere { <3,0,0>,.9 normal { average normal_map { [1 ripples 1 ] [1 gradient x 1] } } pigment { checker } }
mesh { triangle { <-4,-3,0>,<-2,-3,0>,<-3,-1,0> } pigment { image_pattern { png "pal.png" } } }
sphere { <-1,-2,0>,.9 interior_texture { pigment { gradient y } } pigment { rgbt .9 } }
sphere { <1,-2,0>,.9 pigment { average pigment_map { [1 P] [1 checker rgb 1 rgb 0] [1 image_map { png "pal.png" }] } } normal { function { sin(x*9)*.1 } } }
sphere { <3,-2,0>,.9 texture { pigment { checker pigment { gradient x } pigment { P } } } texture { pigment { marble color_map { [0 rgbt 1][1 rgbt <1,0,0,.3>] } } } }
