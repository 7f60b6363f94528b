// More kinds of files, and the gamma of the statement: #version 3.7; global_settings { assumed_gamma srgb }
#version 3.7; global_settings { assumed_gamma srgb }
#include "panels.inc"
More_Files()
