#version 3.7;
#declare A = 1;
#if (A && A)
#end
