// Unions of unions that stay together: as members of a difference, under clipped_by, with
// split_union off. Their members' faces coincide, and of those at one depth the last one shows.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.5, 3, -9> look_at <0.2, 0.1, 0> angle 48 }
light_source { <-5, 10, -8> rgb 1 }
plane { y, -1.8 pigment { checker rgb 0.9 rgb 0.6 } }

#macro Column(Level, Place, Size)
  #if (Level = 0)
    union {
      box { Place, Place + Size*0.9 pigment { rgb <1, 0.5, 0.2> } }
      box { Place, Place + Size*<0.9, 0.5, 0.9> pigment { rgb <0.2, 0.6, 1> } }
      sphere { Place + Size/2, Size*0.52 }
    }
  #else
    union {
      Column(Level - 1, Place, Size/2)
      Column(Level - 1, Place + Size/2*x, Size/2)
      Column(Level - 1, Place + Size/2*z, Size/2)
      Column(Level - 1, Place + Size/2*y, Size/2)
      split_union (mod(Level, 2) = 0)
    }
  #end
#end

object { Column(4, <-3.8, -1.8, -1>, 3.2) pigment { rgb <0.4, 0.8, 0.3> } }
object {
  Column(3, <-0.2, -1.8, -1>, 2)
  clipped_by { plane { x + y, 0.1 } }
  pigment { rgb <0.8, 0.3, 0.6> }
}
difference {
  sphere { <3, -0.6, 0>, 1.2 }
  Column(3, <2.2, -0.9, -1.6>, 1.8)
  pigment { rgb <0.8, 0.8, 0.3> }
}
merge {
  Column(2, <0.4, 0.4, 1>, 1.5)
  sphere { <1.2, 1, 1.5>, 0.6 }
  pigment { rgbt <0.6, 0.9, 0.9, 0.4> }
}
