// Scenes of the first versions: a map type and a plane in front of the image (without effect), a grain in front
// of a texture's name.
#version 1.0
#declare Paint = texture { color red 0.2 green 0.7 blue 1 }
camera { location <0 0 -4> direction <0 0 1> up <0 1 0> right <1.3333 0 0> }
object { light_source { <-4 5 -9> color red 1 green 1 blue 1 } }
object {
  plane { <0 0 1> 1 }
  texture { image_map { 2 <1 -1 0> gif "interlaced.gif" interpolate 2.0 } ambient 0.6 scale <2 2 1> }
}
object { sphere { <-1 0 0> 0.6 } texture { image_map { 1 gif "interlaced.gif" } ambient 0.4 } }
object { sphere { <1 0 0> 0.6 } texture { 0.0 Paint ambient 0.3 } }
