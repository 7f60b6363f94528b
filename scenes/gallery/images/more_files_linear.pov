// More kinds of files, and the gamma of the statement: #version 3.7; global_settings { assumed_gamma 1.0 }
#version 3.7; global_settings { assumed_gamma 1.0 }
#include "panels.inc"
More_Files()
