#version 3.7;
sphere {
  0, 1
  interior { ior 1.5 colour 3 }
}
