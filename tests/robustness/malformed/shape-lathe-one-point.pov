#version 3.7;
lathe {
  linear_spline
  1,
  <0, 0>
}
