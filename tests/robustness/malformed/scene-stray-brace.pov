#version 3.7;
sphere { 0, 1 pigment { rgb 1 } } }
light_source { 10, 1 }
