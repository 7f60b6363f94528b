#version 3.7;
#declare Ball = sphere { 0, 1 }
#declare N = 1;
#declare A = trace(Ball, -5 * z, z, N);
