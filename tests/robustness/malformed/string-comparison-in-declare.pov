#version 3.7;
#declare A = "a" < "b";
