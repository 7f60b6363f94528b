#version 3.7;
#declare A = 2;
#declare B = A ^ 2;
