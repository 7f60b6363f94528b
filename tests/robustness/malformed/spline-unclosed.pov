#version 3.7;
#declare S = spline { cubic_spline 0, x, 1, y
#declare A = S(0.5);
