// Intersections of many convex parts as members of other CSG: a merge of two cut stones, a union that is
// cut out, and one that is clipped.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 }
camera { location <0, 3, -7> look_at <0, -0.2, 0> angle 45 }
light_source { <-6, 8, -10>, 1 }
background { rgb <0.1, 0.15, 0.25> }
plane { y, -1.3 pigment { checker rgb 0.8, rgb <0.3, 0.3, 0.5> } }
#declare Stone = intersection {
  #for (I, 0, 39) plane { <sin(I * 2.4), cos(I * 1.7), sin(I)>, 0.8 } #end
  #for (I, 0, 5) sphere { vrotate(<0.85, 0, 0>, <20 * I, 60 * I, 30 * I>), 0.35 inverse } #end
}
merge {
  object { Stone translate <-1.9, 0, 0> }
  object { Stone rotate 50 translate <-1.2, 0.3, 0.2> }
  pigment { rgbt <0.9, 1, 0.95, 0.8> }
  finish { specular 0.6 reflection 0.1 }
  interior { ior 1.4 }
}
difference {
  box { <-0.7, -1, -0.7>, <0.7, 0.6, 0.7> }
  union {
    object { Stone scale 0.7 translate <0.4, 0.6, -0.6> }
    object { Stone scale 0.6 translate <-0.5, 0, -0.8> }
    torus { 0.6, 0.15 translate 0.6*y }
  }
  pigment { rgb <0.9, 0.75, 0.4> }
  translate <0.5, -0.2, 0>
}
object { Stone clipped_by { torus { 0.6, 0.45 } } pigment { rgb <0.8, 0.4, 0.5> } translate <2.2, -0.2, 0> }
