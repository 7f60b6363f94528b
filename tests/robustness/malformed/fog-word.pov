#version 3.7;
fog {
  distance 10
  colour rgb 1
  density 3
}
