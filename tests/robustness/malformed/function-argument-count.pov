#version 3.7;
#declare F = function(a) { a }
#declare G = function { F(x, y) }
