#version 3.7;
#declare A = 5.x;
