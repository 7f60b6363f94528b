#version 3.7;
#declare R = seed(1);
#declare A = rand(R);
#declare B = rand(R + 7);
