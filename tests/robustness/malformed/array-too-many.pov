#version 3.7;
#declare A = array[2] {
  1,
  2,
  3
}
