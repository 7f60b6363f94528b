#version 3.7;
#declare A = array[0]
