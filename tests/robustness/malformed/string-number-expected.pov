#version 3.7;
#declare A = concat("a", 3);
