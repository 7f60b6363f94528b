// Light through merges whose members share a face: whether a point of it lies in both members is
// decided by the last bits of the shadow ray.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0.3, 6.2, -7> look_at <0, 0, -0.3> angle 45 }
light_source { <5, 10, -8>, 1 }
light_source { <-8, 6, -3>, 0.5 }
#declare Clear = texture { pigment { rgbt <0.95, 1, 0.95, 0.5> } }
plane { y, 0 pigment { rgb 1 } }
#declare Two = merge {
  box { <-1, 0, -1>, <0, 1, 1> }
  box { <0, 0, -1>, <1, 1, 1> }
  texture { Clear }
  scale 0.7
}
object { Two translate <-1.7, 0.3, 1.2> no_image }
object { Two rotate 30 * y translate <1.2, 0, 1.2> }
object { Two rotate 30 * y interior { ior 1.5 } translate <-1.5, 0.2, -1.2> }
merge {
  prism { linear_spline 0, 0.6, 5, <-0.8, -0.7>, <0.8, -0.7>, <0.4, 0.8>, <-0.7, 0.7>, <-0.8, -0.7> }
  prism { linear_spline 0.6, 1, 5, <-0.8, -0.7>, <0.8, -0.7>, <0.4, 0.8>, <-0.7, 0.7>, <-0.8, -0.7> }
  texture { Clear }
  interior { ior 1.4 }
  rotate <0, 20, 0>
  translate <1.5, 0, -1.2>
}
