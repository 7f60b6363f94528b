#version 3.7;
#read (F, A)
