#version 3.7;
#fopen F "values.txt" read
#fclose F
#write (F, rgb 1)
