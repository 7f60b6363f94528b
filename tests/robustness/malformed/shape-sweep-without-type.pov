#version 3.7;
sphere_sweep {
  3,
  0, 1, x, 1, 2*x, 1
}
