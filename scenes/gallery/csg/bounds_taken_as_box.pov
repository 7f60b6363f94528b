// A bound that is left out for its box's sake: the box cuts the sphere, not its shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 3.5, -6> look_at 0 angle 45 }
light_source { <5, 8, -6> rgb 1 }
light_source { <-6, 6, -4> rgb <0.3, 0.3, 0.5> }
plane { y, -1.3 pigment { checker rgb 0.9 rgb <0.4, 0.3, 0.3> } }
sphere {
  0, 1
  bounded_by { box { -0.6, 0.6 } }
  pigment { rgb <0.3, 0.6, 1> }
}
