#version 3.7;
#declare Patterned = texture {
  checker
  texture { pigment { rgb 1 } }
  texture { pigment { rgb 0 } }
}
sphere {
  0, 1
  texture { Patterned }
  texture { pigment { rgbt 0.5 } }
}
