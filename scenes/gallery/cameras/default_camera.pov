#version 3.7;
// No camera statement at all: right is 1.33 x at the origin.
#include "surroundings.inc"


