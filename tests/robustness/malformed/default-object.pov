#version 3.7;
#default { sphere { 0, 1 } }
