#version 3.7;
#declare F = function { x + * y }
