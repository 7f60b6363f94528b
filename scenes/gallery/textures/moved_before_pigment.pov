// Transforms of a texture that has only a plain colour yet: a pigment written after them starts
// moved by them, as does one that follows another, and all that start from such a default.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.4, -8> look_at <0, 0.2, 0> angle 50 }
light_source { <-7, 9, -11> rgb 1 }
background { rgb <0.3, 0.35, 0.4> }
#declare Hexagons = pigment { hexagon rgb <1, 0.3, 0.2>, rgb <0.2, 0.7, 0.3>, rgb <0.2, 0.3, 1> }
sphere { <-2.6, 1.3, 0>, 1
  texture { scale 0.35 pigment { hexagon rgb <1, 0.3, 0.2>, rgb <0.2, 0.7, 0.3>, rgb <0.2, 0.3, 1> } }
}
sphere { <0, 1.3, 0>, 1
  texture { pigment { rgb 1 } rotate 40*z scale <1, 0.3, 1>
    pigment { checker rgb 1, rgb <0.1, 0.2, 0.6> scale 0.5 } rotate 30*y }
}
sphere { 0, 1
  pigment { rgb 1 } scale 0.5 rotate 30*z
  pigment { checker rgb 1, rgb <0.6, 0.1, 0.2> scale 0.7 } scale 2 translate <2.6, 1.3, 0>
}
sphere { <-2.6, -1, 0>, 1 texture { scale 0.2 pigment { Hexagons } } }
sphere { <0, -1, 0>, 1
  texture { gradient y scale 0.7
    texture_map { [0.3 scale 0.2 pigment { wood }] [0.7 translate 3*x pigment { agate scale 0.5 }] } }
}
#default { texture { pigment { rgb <0.9, 0.8, 0.5> } scale <0.2, 0.6, 1> rotate 20*z } }
sphere { <2.6, -1, 0>, 1 pigment { checker rgb <0.9, 0.8, 0.5>, rgb 0.1 } }
