#version 3.7;
#declare C = rgb 1;
#declare D = C filter 0.7;
