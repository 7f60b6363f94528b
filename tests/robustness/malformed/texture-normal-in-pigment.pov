#version 3.7;
sphere {
  0, 1
  pigment {
    bumps 0.5
    slope_map { [0 <0, 1>] }
  }
}
