// Meshes with inside_vector whose faces leave holes: through a hole points outside the box of the mesh
// count as inside, for the copies of a declared cut, too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.3, 3.2, -9> look_at <0, 0.1, 0> angle 45 }
light_source { <5, 10, -8>, 1 }
light_source { <-8, 6, -3>, 0.5 }
background { rgb <0.4, 0.6, 0.8> }
#macro Square(A, B, C, D) triangle { A, B, C } triangle { A, C, D } #end
#macro Cube(Direction, Front, Half)
  mesh {
    #if (Front) Square(<-1, -1, -1>, <1, -1, -1>, <1, 1, -1>, <-1, 1, -1>) #end
    Square(<-1, -1, 1>, <1, -1, 1>, <1, 1, 1>, <-1, 1, 1>)
    Square(<-1, -1, -1>, <-1, 1, -1>, <-1, 1, 1>, <-1, -1, 1>)
    Square(<1, -1, -1>, <1, 1, -1>, <1, 1, 1>, <1, -1, 1>)
    Square(<-1, -1, -1>, <1, -1, -1>, <1, -1, 1>, <-1, -1, 1>)
    triangle { <-1, 1, -1>, <1, 1, -1>, <1, 1, 1> }
    #if (!Half) triangle { <-1, 1, -1>, <1, 1, 1>, <-1, 1, 1> } #end
    inside_vector Direction
    pigment { rgb <0.9, 0.6, 0.3> }
  }
#end
difference {
  box { -1.5, 1.5 pigment { rgb <0.3, 0.7, 0.4> } }
  object { Cube(z, false, false) }
  rotate 20 * y
  scale 0.7
  translate <-2.2, 1, 0>
}
intersection {
  box { -1.7, 1.7 pigment { rgb <0.3, 0.7, 0.4> } }
  object { Cube(<0.3, 0.2, 1>, false, true) }
  rotate <-20, 20, 0>
  scale 0.8
  translate <0.4, 1, 0>
}
merge {
  box { -1.3, <1.3, 0.3, 1.3> pigment { rgb <0.3, 0.7, 0.4> } }
  object { Cube(<1, 0.1, 0>, true, true) }
  rotate 20 * y
  scale 0.7
  translate <2.7, 1, 0>
}
#declare Cut = difference {
  sphere { 0, 1.5 pigment { rgb <0.3, 0.7, 0.4> } }
  object { Cube(<0.3, 0.2, 1>, false, false) }
  plane { z, -0.7 }
}
#for (I, 0, 5)
  object { Cut scale 0.4 rotate I * 50 * y translate <1.3 * I - 3.2, -1.4, 0> }
#end
