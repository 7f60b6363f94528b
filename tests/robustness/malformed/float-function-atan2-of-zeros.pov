#version 3.7;
#declare A = atan2(1, 1);
#declare B = atan2(0, 0);
