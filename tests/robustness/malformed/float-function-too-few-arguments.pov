#version 3.7;
#declare A = select(1, 2);
