#version 3.7;
#declare F = function(a, b) { a + b }
#declare A = F(1, 2);
#declare B = F(1, 2, 3);
