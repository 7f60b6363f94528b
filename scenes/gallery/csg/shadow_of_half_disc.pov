// Boxes of intersections cut what the camera sees and the shadow, too: inside of a disc is all that lies
// behind it. The box of an inverse clip cuts what the camera sees of a quartic, and not its shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -7> look_at <0, 0, 0> angle 45 }
background { rgb <0.2, 0.3, 0.5> }
light_source { <3, 8, -4>, rgb 1 }
plane { y, -1.3 pigment { checker rgb 1 rgb 0.5 } }
#default { texture { pigment { rgb <1, 0.5, 0.2> } } }
intersection {
  disc { 0, <-0.85, 0.48, -0.71>, 0.63 }
  box { <-2, 0, -2>, <0.16, 2, 2> }
  translate -2.2 * x
}
intersection { disc { 0, z, 0.63, 0.2 } box { <-2, 0, -2>, <0.16, 2, 2> } translate -0.5 * x }
intersection {
  disc { 0, <-0.85, 0.48, -0.71>, 0.63 }
  sphere { 0.3 * x, 0.5 }
  translate <0.8, 0, -1>
}
quartic {
  <1, 0,0,0, 0,0,0,0,0,0, 0,0,0,0,0,0,0,0,0,0, 1, 0,0,0,0,0,0,0,0, 0, 1, 0,0,0, -0.8>
  clipped_by { sphere { 0, 0.75 inverse } }
  translate 2.2 * x
}
