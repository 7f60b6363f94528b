// A blob's own statement sets its box last: the bound that is left out does not cut it; a copy's does.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 3.5, -6> look_at <0.3, 0, 0> angle 50 }
light_source { <5, 8, -6> rgb 1 }
plane { y, -1.3 pigment { checker rgb 0.9 rgb <0.4, 0.3, 0.3> } }
#declare Bean = blob {
  threshold 0.5
  sphere { <-0.6, 0, 0>, 1.2, 1 }
  sphere { <0.6, 0, 0>, 1.2, 1 }
  bounded_by { sphere { 0, 0.9 } }
}
blob {
  threshold 0.5
  sphere { <-0.6, 0, 0>, 1.2, 1 }
  sphere { <0.6, 0, 0>, 1.2, 1 }
  bounded_by { box { -0.9, 0.9 } }
  pigment { rgb <0.3, 0.6, 1> }
}
object { Bean translate <0.6, 0.2, 2.5> pigment { rgb <1, 0.6, 0.2> } }
