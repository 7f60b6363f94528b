#version 3.7;
#declare A = "fine";
#declare B = "\u12";
