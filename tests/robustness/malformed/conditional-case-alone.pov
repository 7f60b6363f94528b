#version 3.7;
#if (1)
  #case (3)
#end
