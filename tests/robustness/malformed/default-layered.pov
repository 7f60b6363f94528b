#version 3.7;
#declare Two = texture { pigment { rgb 1 } } texture { pigment { rgbt 0.5 } }
#default { texture { Two } }
