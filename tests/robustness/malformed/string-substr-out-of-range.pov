#version 3.7;
#declare A = "Albrecht";
#declare B = substr(A, 3, 2);
#declare C = substr(A, 6, 9);
