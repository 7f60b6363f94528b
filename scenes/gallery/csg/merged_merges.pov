// A merge of merges of glass: inner surfaces vanish on all levels, also under no_reflection and clipped.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 2, -6> look_at 0 angle 45 }
light_source { <-6, 8, -10>, 1 }
background { rgb <0.1, 0.15, 0.25> }
plane { y, -1.6 pigment { checker rgb 0.8, rgb <0.3, 0.3, 0.5> } finish { reflection 0.3 } }
#declare Random = seed(3);
#macro Cluster(Count)
  merge {
    #for (I, 1, Count)
      sphere { <rand(Random), rand(Random), rand(Random)> * 2.4 - 1.2, 0.3 + 0.2 * rand(Random) }
      box { -0.2, 0.2 rotate 360 * rand(Random) translate <rand(Random), rand(Random), rand(Random)> * 2.4 - 1.2 }
    #end
  }
#end
merge {
  Cluster(5)
  Cluster(6)
  object { Cluster(3) no_reflection }
  intersection { Cluster(4) plane { x, 0.4 } }
  object { Cluster(4) clipped_by { plane { y, 0.3 } } }
  merge { Cluster(2) Cluster(2) }
  pigment { rgbt <0.8, 0.95, 0.9, 0.8> }
  finish { specular 0.5 reflection 0.05 }
  interior { ior 1.15 }
}
