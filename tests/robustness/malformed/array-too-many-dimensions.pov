#version 3.7;
#declare A = array[1][1][1][1][1]
#declare B = array[1][1][1][1][1][1]
