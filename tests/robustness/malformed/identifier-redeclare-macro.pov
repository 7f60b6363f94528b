#version 3.7;
#macro M() 1 #end
#declare M = 2;
