// A plane with bounds in a union: a move of the union forgets the box of the bounds, a move of the plane itself does not.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7> look_at 0 angle 55 }
light_source { <-6, 9, -6> 1 shadowless }
background { rgb <0.3, 0.2, 0.5> }
#default { pigment { checker rgb 1 rgb 0.5 scale 0.3 } }
union { box { <-0.8, -0.5, -0.6>, <0.8, 0.5, 0.6> } plane { y, 0 bounded_by { box { -1, 0.6 } } } rotate 4*z translate <-2.2, -1, -0.1> }
object { union { sphere { 0, 0.5 } plane { y, 0 bounded_by { box { -1, 0.6 } } translate 0.4*y } } pigment { rgb <0.9, 0.4, 0.3> } }
union { sphere { 2*x, 0.7 } plane { -z, 0 rotate 30*y bounded_by { box { -1, 0.6 } } translate 2*x } pigment { rgb <0.4, 0.8, 0.3> } }
