// More kinds of files, and the gamma of the statement: #version 3.6;
#version 3.6;
#include "panels.inc"
More_Files()
