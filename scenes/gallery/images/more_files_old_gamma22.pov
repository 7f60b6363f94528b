// More kinds of files, and the gamma of the statement: #version 3.6; global_settings { assumed_gamma 2.2 }
#version 3.6; global_settings { assumed_gamma 2.2 }
#include "panels.inc"
More_Files()
