#version 3.7;
#declare A = <1, 2, 3, 4, 5>;
#declare B = <1, 2, 3, 4, 5, 6>;
