#version 3.7;
#declare A = array[3]
#for (A[0], 1, 3)
#end
