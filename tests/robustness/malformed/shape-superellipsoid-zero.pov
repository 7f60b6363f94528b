#version 3.7;
superellipsoid {
  0, 1
}
