#version 3.7;
poly {
  50, <1, 2, 3>
}
