#version 3.7;
#declare B = background { rgb 1 }
