#version 3.7;
bicubic_patch {
  type 1
  <0, 0, 0>, <1, 0, 0>, <2, 0, 0>, <3, 0, 0>
}
