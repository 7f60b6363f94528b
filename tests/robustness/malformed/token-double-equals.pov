#version 3.7;
#declare A = 2;
#if (A == 2)
  #declare B = 1;
#end
