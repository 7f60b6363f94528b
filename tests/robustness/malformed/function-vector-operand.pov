#version 3.7;
#declare V = <1, 2, 3>;
#declare F = function { x + V }
