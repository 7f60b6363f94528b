#version 3.7;
#declare Radius = 2
