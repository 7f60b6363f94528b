#version 3.7;
#declare A = rgb <1, 2, 3> * 2 + <1, 1, 1>;
#declare B = rgb <1, 2, 3> * 2 + rgb 1;
