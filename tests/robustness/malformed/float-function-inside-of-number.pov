#version 3.7;
#declare N = 3;
#declare A = inside(N, <0, 0, 0>);
