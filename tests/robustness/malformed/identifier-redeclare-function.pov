#version 3.7;
#declare F = function(x) { x }
#declare F = function(x) { 2 * x }
