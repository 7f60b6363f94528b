// A stack declared in language 3.5 (as the standard includes are) filters; given to an object, declared
// anew or put into tiles in language 3.1 its upper layers let through instead.
#version 3.5;
global_settings { assumed_gamma 1 }
#declare Base = texture { pigment { rgb <1, 0.6, 0.3> } }
#declare Filter = texture { pigment { rgbf <0.4, 1, 0.5, 0.8> } }
#declare Bands = texture { pigment { gradient y color_map { [0 rgbf <0.3, 0.4, 1, 0.2>] [1 rgbf <0.9, 1, 0.3, 0.9>] } scale 0.5 } }
#declare Stack = texture { Base } texture { Filter } texture { Bands }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
background { rgb <0.15, 0.2, 0.3> }
#version 3.1;
#declare Again = texture { Stack finish { phong 0.5 } }
sphere { <0, 1.15, 0>, 0.95 texture { Stack } }
sphere { <2.3, 1.15, 0>, 0.95 texture { tiles { texture { Stack } tile2 texture { Base } } } }
sphere { <-1.2, -1.15, 0>, 0.95 material { texture { Stack } } }
#version 3.5;
sphere { <1.2, -1.15, 0>, 0.95 texture { Again } }
#version 3.1;
