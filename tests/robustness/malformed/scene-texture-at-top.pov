#version 3.7;
texture { pigment { rgb 1 } }
