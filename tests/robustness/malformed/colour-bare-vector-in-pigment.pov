#version 3.7;
sphere {
  0, 1
  pigment { <1, 0, 0> }
}
