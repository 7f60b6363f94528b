#version 3.7;
#fopen F "values.txt" read
#read (F, A)
#read (F, B, C)
