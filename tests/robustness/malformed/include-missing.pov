#version 3.7;
#include "colors.inc"
#include "there_is_no_such_file.inc"
sphere { 0, 1 }
