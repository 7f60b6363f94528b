// Where there are too few objects for a hierarchy, nothing hides the look of a light.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -6*z look_at 0 }
light_source {
  0 rgb 1
  looks_like { sphere { 0, 0.5 pigment { rgb <1, .9, .6> } finish { ambient 1 } no_image no_reflection } }
  translate <1, .5, 0>
}
plane { z, 3 pigment { rgb .2 } finish { reflection 0.5 } }
