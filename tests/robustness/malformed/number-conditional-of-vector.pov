#version 3.7;
#declare A = (x ? 1 : 2);
