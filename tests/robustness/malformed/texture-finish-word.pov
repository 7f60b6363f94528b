#version 3.7;
sphere {
  0, 1
  finish {
    specular 0.5
    shininess 3
  }
}
