#version 3.7;
#declare A = 1;
#undef A
#undef sphere
