#version 3.7;
#macro Nest(N)
  #if (N > 0) #if (1) #if (1)
    Nest(N - 1)
  #end #end #end
#end
Nest(80)
