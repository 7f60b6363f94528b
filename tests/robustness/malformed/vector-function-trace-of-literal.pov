#version 3.7;
#declare A = trace(sphere { 0, 1 }, -5 * z, z);
