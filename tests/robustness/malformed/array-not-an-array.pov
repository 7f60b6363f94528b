#version 3.7;
#declare A = 3;
#declare B = A[0];
