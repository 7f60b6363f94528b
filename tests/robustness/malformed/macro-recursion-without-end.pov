#version 3.7;
#macro Again(N)
  Again(N + 1)
#end
Again(1)
