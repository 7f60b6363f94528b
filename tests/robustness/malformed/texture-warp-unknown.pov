#version 3.7;
sphere {
  0, 1
  pigment { bozo warp { twirl 3 } }
}
