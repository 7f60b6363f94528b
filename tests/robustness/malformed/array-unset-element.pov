#version 3.7;
#declare A = array[2]
#declare A[0] = 3;
#declare B = A[0] + A[1];
