#version 3.7;
#fopen F "values.txt" read
#write (F, 3)
