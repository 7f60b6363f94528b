#version 3.7;
#include 3
