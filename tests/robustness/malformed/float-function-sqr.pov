#version 3.7;
#declare A = pow(3, 2);
#declare B = sqr(3);
