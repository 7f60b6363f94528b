#version 3.7;
#declare Move = transform { translate x }
sphere { 0, 1 Move }
