#version 3.7;
polygon {
  5,
  <0, 0>, <1, 0>, <1, 1>
}
