#version 3.7;
#Declare A = 1;
