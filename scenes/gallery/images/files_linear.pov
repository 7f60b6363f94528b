// Every kind of file as image_map: #version 3.7; global_settings { assumed_gamma 1.0 }
#version 3.7; global_settings { assumed_gamma 1.0 }
#include "panels.inc"
Files()
