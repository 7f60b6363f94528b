#version 3.7;
#declare A = sqrt(4);
#declare B = sqrt(-4);
