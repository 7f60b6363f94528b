#version 3.7;
#declare F = function { x^2 + y }
