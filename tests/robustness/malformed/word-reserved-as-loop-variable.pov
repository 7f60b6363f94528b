#version 3.7;
#for (x, 1, 3)
#end
