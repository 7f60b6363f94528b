#version 3.7;
sphere {
  0, 1
  pigment {
    gradient y
    color_map {
      [0 rgb 1]
      [1 <1, 0, 0>]
    }
  }
}
