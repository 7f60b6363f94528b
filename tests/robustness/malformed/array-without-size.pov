#version 3.7;
#declare A = array { 1, 2 }
