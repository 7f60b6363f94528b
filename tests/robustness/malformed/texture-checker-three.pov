#version 3.7;
sphere {
  0, 1
  pigment { checker rgb 1, rgb 0, rgb 0.5, rgb 0.2 }
}
