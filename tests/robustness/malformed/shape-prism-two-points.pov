#version 3.7;
prism {
  linear_spline
  0, 1, 2,
  <0, 0>, <1, 0>
}
