// Looks of lights that do not show themselves to the camera or to mirrors; a whole union, bound, shows them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -6*z look_at 0 }
#declare Look = sphere { 0, 0.5 pigment { rgb <1, .9, .6> } finish { ambient 1 } }
light_source { 0 rgb .4 looks_like { object { Look no_image } } translate <-1.5, 1, 0> }
light_source { 0 rgb .4 looks_like { object { Look no_reflection } } translate <0, 1, 0> }
light_source { 0 rgb .4 looks_like { Look } translate <1.5, 1, 0> }
union {
  light_source { 0 rgb .4 looks_like { object { Look no_reflection } } translate <-1.5, -.8, 0> }
  light_source { 0 rgb .4 looks_like { object { Look no_image } } translate <1.5, -.8, 0> }
  sphere { <0, -.8, 0>, .5 pigment { rgb <.5, .7, 1> } }
  split_union off bounded_by { box { <-3, -2, -1>, <3, 0, 1> } }
}
plane { z, 3 pigment { rgb .2 } finish { reflection 0.5 } }
