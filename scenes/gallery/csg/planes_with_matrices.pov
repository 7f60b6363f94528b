// Solids cut by planes that a matrix or a transform{} has moved: the boxes of such solids are worked out
// in POV-Ray's own way, and what lies beyond them is cut off.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> right 4/3*x look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -10> rgb 1 }
plane { y, -1.5 pigment { checker rgb 0.8 rgb 0.5 } }
#declare Shift = transform { translate <-0.4, 0.3, 0> }
#declare Turn = transform { rotate <0, 0, 30> translate <0.2, 0.6, 0> }
#declare Grow = transform { scale <2, 1, 3> translate <0.5, -0.2, 0.3> }
#declare Aslant = transform { matrix <1, 0.2, 0, 0, 1, 0, 0.1, 0, 1, -0.3, 0, 0.2> }
#macro Cut(Place, Move, Normal, Far)
  intersection {
    sphere { 0, 1 }
    plane { Normal, Far transform { Move } }
    pigment { rgb <0.9, 0.6, 0.2> }
    translate Place
  }
#end
Cut(<-3, 1, 0>, Shift, -x, -0.1)
Cut(<-1, 1, 0>, Shift, x, 0.6)
Cut(<1, 1, 0>, Turn, y, -0.1)
Cut(<3, 1, 0>, Turn, x, 0.2)
Cut(<-3, -1, 0>, Grow, x, 0.1)
Cut(<-1, -1, 0>, Grow, -z, 0.3)
Cut(<1, -1, 0>, Aslant, -x, -0.1)
Cut(<3, -1, 0>, Aslant, y, 0.5)
