// An include file that includes itself, far too deep.
#version 3.7;
#include "recursive.inc"
