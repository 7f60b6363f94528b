#version 3.7;
sphere {
  0, 1
  pigment { image_map { 3 } }
}
