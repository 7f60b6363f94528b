#version 3.7;
#declare A = ln(0);
