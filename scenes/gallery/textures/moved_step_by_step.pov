// Patterns that jump right in the faces they cover: which square a point belongs to is decided by the last
// digits of all the moves, one after the other.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-2.1, 0.3, -6> right 4/3*x angle 40 look_at <0.3, 0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Slab = box { -1, <1, 1, 0> pigment { checker rgb 0.9 rgb <0.2, 0.4, 0.8> scale 0.1 } scale 0.8 rotate <10, 20, 30> }
union {
  object { Slab translate <-0.9, 0.6, 0.3> }
  object { Slab rotate 40*z scale 0.7 translate <0.9, -0.6, 0.1> }
  rotate <15, 35, 40> scale <1.1, 1.2, 0.9>
}
plane { z, 0 pigment { gradient z color_map { [0 rgb <0.9, 0.6, 0.3>] [1 rgb 0.2] } scale 0.1 } scale 1.7 rotate 33*x translate 2*z }
polygon { 5, <-0.8, -0.8>, <0.8, -0.7>, <0.6, 0.9>, <-0.5, 0.6>, <-0.8, -0.8> pigment { gradient z color_map { [0 rgb <0.3, 0.8, 0.4>] [1 rgb 0.1] } scale 0.1 } matrix <1, 0, 0, 0, 1, -0.18, 0, 0.14, 1, 1.2, 0.8, 0> }
