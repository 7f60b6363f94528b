#version 3.7;
union {
  sphere { 0, 1 }
  3
}
