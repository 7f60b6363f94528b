#version 3.7;
#if ("yes")
#end
