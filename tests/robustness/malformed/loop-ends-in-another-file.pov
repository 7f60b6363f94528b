#version 3.7;
#declare I = 0;
#while (I < 2)
  #declare I = I + 1;
  #include "lone_end.inc"
