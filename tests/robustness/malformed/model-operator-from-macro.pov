#version 3.7;
#macro Plus() + #end
#declare A = (1 Plus() 2);
#declare B = 1 Plus() 2;
