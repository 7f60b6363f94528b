// Every kind of file as image_map: #version 3.7; global_settings { assumed_gamma srgb }
#version 3.7; global_settings { assumed_gamma srgb }
#include "panels.inc"
Files()
