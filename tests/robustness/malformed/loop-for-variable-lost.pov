#version 3.7;
#for (I, 1, 10)
  #undef I
#end
