// Every kind of file as image_map: #version 3.6;
#version 3.6;
#include "panels.inc"
Files()
