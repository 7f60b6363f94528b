#version 3.7;
#declare V = <1, 2>;
#declare A = V.y;
#declare B = V.z;
