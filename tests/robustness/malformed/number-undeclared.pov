#version 3.7;
#declare Height = 4;
#declare B = Heigth * 2;
