#version 3.7;
sphere {
  0, 1
  bounded_by { triangle { 0, x, y } }
}
