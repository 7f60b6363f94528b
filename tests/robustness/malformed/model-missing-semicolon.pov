#version 3.7;
#declare Radius = 2
#declare Height = 3;
