#version 3.7;
#declare A = log(
  -3
);
