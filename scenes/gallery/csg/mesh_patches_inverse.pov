// Meshes without inside_vector cut out of others: they contain nothing, inverse or not, so that what they
// are cut out of is gone; their normals, which choose the interior_texture, turn over.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 angle 50 } 
light_source { <3,5,-8>, 1 }
#declare M = mesh { triangle { <-1,-1,0>, <1,-1,0>, <0,1,0> } triangle { <-1,-1,0>, <1,-1,-2>, <0,1,0> } }
#declare X = texture { pigment { rgb <.2,.9,.3> } }
#declare Y = texture { pigment { rgb <.2,.3,.9> } }
#macro Z(I,J) texture { pigment { rgb .8 } } interior_texture { pigment { rgb <1,.2,.2> } } scale .5 translate <I,J,0> #end
difference { sphere { 0, .8 texture { X } } object { M texture { Y } } Z(-2,1) }
difference { object { M texture { Y } } sphere { 0, .8 texture { X } } Z(-1,1) }
difference { sphere { 0, .8 texture { X } } object { M texture { Y } inverse } Z(0,1) }
intersection { sphere { 0, .8 texture { X } } object { M texture { Y } } Z(1,1) }
intersection { sphere { 0, .8 texture { X } } object { M texture { Y } inverse } Z(2,1) }
merge { sphere { 0, .8 texture { X } } object { M texture { Y } inverse } Z(-2,0) }
merge { sphere { 0, .8 texture { X } } object { M texture { Y } } Z(-1,0) }
union { sphere { 0, .8 texture { X } } object { M texture { Y } inverse } Z(0,0) }
difference { sphere { 0, .8 texture { X } } union { object { M } box { -1, .3 } texture { Y } } Z(-2,-1) }
difference { sphere { 0, .8 texture { X } } intersection { object { M } box { -1, .3 } texture { Y } } Z(-1,-1) }
intersection { sphere { 0, .8 texture { X } } difference { box { -1, 1 } object { M } texture { Y } inverse } Z(0,-1) }
