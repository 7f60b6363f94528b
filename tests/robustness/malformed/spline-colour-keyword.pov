#version 3.7;
#declare S = spline {
  linear_spline
  0, <1, 0, 0>,
  1, rgb x
}
