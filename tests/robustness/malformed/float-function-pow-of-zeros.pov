#version 3.7;
#declare A = pow(0,
  0);
