#version 3.7;
#declare C = rgbft <1, 2, 3, 4, 5>;
sphere {
  C, 1
}
