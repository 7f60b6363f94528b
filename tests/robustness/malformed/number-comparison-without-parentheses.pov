#version 3.7;
#declare A = (2 > 1);
#declare B = 2 > 1;
