#version 3.7;
#declare F = function { 3 * !x }
