#version 3.7;
#declare F = function {
  sin(x) + wobble(y)
}
