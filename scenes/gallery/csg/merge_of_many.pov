// Clear merges of more convex solids than one sweep takes, most of them within others: all inside, and
// with merges, unions and a torus among the members, cut by a sphere.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 3 }
camera { location <0, 2, -9> look_at 0 }
light_source { <10, 20, -20> rgb 1 }
background { rgb <.4, .5, .7> }
plane { y, -3 pigment { checker rgb 1 rgb .3 } }
#declare R = seed(4);
#macro Some(Size, Spread)
  box {
    -Size, Size rotate 360 * <rand(R), rand(R), rand(R)>
    translate Spread * <rand(R) - .5, rand(R) - .5, rand(R) - .5>
  }
#end
#declare Part = merge {
  #for (I, 0, 29) Some(<.3, .3, 1.2>, 2) #end
  union { #for (I, 0, 9) sphere { 2 * <rand(R), rand(R), rand(R)> - 1, .5 } #end }
}
#declare Clear = material {
  texture { pigment { rgbt <.9, .95, 1, .8> } finish { specular .5 reflection .1 } }
  interior { ior 1.3 }
}
difference {
  merge { object { Part translate -x } object { Part rotate y*40 translate x } torus { 1.5, .3 } }
  sphere { <0, 0, -1.5>, 1 }
  material { Clear } translate -1.7*x
}
merge { #for (I, 0, 39) Some(<.9, .9, 1.1>, 0) #end material { Clear } translate <2.6, 0, 0> }
