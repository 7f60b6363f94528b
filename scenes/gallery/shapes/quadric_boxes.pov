// Boxes that povray works out for clipped quadrics: of where they stand when the clip is written,
// wrong for hyperboloids but of 1, for paraboloids away from the origin, and moved along after that.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -14> look_at <0, 0.4, 0> angle 46 }
light_source { <-6, 10, -12>, rgb 1 }
plane { y, -4.2 pigment { checker rgb 0.9, rgb 0.6 } }
#declare Hyperboloid = quadric { <1, -1, 1>, <0, 0, 0>, <0, 0, 0>, -2 }
#declare Paraboloid = quadric { <1, 0, 1>, <0, 0, 0>, <0, -1, 0>, 0 }
#declare Tube = quadric { <1, 0, 1>, <0, 0, 0>, <0, 0, 0>, -0.5 }
#declare Slab = plane { y, 1 }
#declare Floor = plane { -y, 1 }
object { Hyperboloid clipped_by { Slab Floor } rotate 30 * z translate <-4, 2, 0> pigment { rgb x } }
intersection { object { Hyperboloid } Slab Floor translate <-4, -2.4, 0> pigment { rgb <1, 1, 0> } }
object {
  Paraboloid translate <0.4, 0.3, 0> clipped_by { plane { y, 2 } } rotate 20 * z
  translate <-1, 1, 0> pigment { rgb y }
}
object { Paraboloid translate 0.6 * y clipped_by { plane { y, 2 } } translate <2, 1, 0> pigment { rgb z } }
object {
  Paraboloid translate -0.7 * y clipped_by { Slab } translate <4.5, 1, 0>
  pigment { rgb <0, 1, 1> } no_shadow
}
object { Tube rotate 40 * z clipped_by { Slab Floor } translate <-0.7, -2.5, 0> pigment { rgb <1, 0, 1> } }
object {
  Tube clipped_by { Slab Floor } rotate 40 * z clipped_by { box { -1, 0.9 } }
  translate <1.7, -2.5, 0> pigment { rgb <1, 0.5, 0> }
}
object {
  Tube rotate 90 * z inverse clipped_by { box { -1.5, 1.5 } } rotate 30 * y
  translate <4.4, -2.5, 0> pigment { rgb 0.8 }
}
