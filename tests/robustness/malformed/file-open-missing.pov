#version 3.7;
#fopen F "there_is_no_such_file.txt" read
