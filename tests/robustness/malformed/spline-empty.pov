#version 3.7;
#declare S = spline { linear_spline }
