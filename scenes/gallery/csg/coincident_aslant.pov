// Coincident faces seen aslant: which pixels show the far wall is a matter of the ray's last bit.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 2.5, -5> look_at <0.3, 0, 0> angle 46 }
light_source { <5, 8, -6> rgb 1 }
background { rgb <0.2, 0.3, 0.4> }

#declare By_Depth = texture {
  pigment { gradient z scale 4 translate -2*z }
  finish { ambient 1 diffuse 0 }
}
intersection {
  box { -1, 1 }
  box { <-1, -0.5, -1>, <1, 1.5, 0.6> }
  texture { By_Depth }
}
difference {
  box { <1.2, -1, -1>, <2, 0.4, 0> pigment { rgb <1, 0.3, 0.2> } }
  box { <1.2, -0.6, -1>, <1.8, 0.1, -0.4> pigment { rgb <0.2, 0.8, 0.3> } }
}
intersection {
  sphere { 0, 0.6 pigment { rgb <1, 0.8, 0.2> } }
  sphere { 0, 0.6 pigment { rgb <0.2, 0.4, 1> } }
  plane { y, 0.4 pigment { rgb 1 } }
  rotate 20*z
  translate <-1.7, 0.4, -0.4>
}
// The same through a mirror.
plane {
  z, 3
  pigment { rgb 0 }
  finish { reflection 0.8 }
}
