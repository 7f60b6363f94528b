#version 3.7;
#declare A = 1;
#if (A)
  sphere { 0, 1 }
