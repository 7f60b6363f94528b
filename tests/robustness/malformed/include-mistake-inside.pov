#version 3.7;
#include "mistake.inc"
sphere { 0, 1 }
