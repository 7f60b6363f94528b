#version 3.7;
#declare Ball = 3;
#macro Ball()
#end
