#version 3.7;
#declare A = chr(65);
#declare B = chr(70000);
