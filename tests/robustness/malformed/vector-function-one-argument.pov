#version 3.7;
#declare A = vcross(x, y);
#declare B = vcross(x);
