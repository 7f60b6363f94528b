#version 3.7;
#declare A = (1 + (2 * 3);
sphere { 0, 1 }
