#version 3.7;
sphere {
  0, 1
  clipped_by { plane { y, 0 pigment { rgb 1 } } }
}
