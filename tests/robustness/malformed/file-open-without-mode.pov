#version 3.7;
#fopen F "values.txt"
sphere { 0, 1 }
