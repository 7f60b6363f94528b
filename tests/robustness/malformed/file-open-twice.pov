#version 3.7;
#fopen F "values.txt" read
#fopen F "values.txt" read
