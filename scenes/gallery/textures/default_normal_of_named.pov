// A named texture without a normal: a normal{} that it gets starts from the default in force then.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 42 }
light_source { <-5, 8, -10> rgb 1 }
#declare Plain = texture { pigment { rgb <0.9, 0.7, 0.5> } finish { phong 0.4 } }
#default { normal { bumps 0.6 scale 0.2 } }
sphere { <-2.2, 1.1, 0>, 1 texture { Plain } }
sphere { <0, 1.1, 0>, 1 texture { Plain } normal { dents 0.9 } }
sphere { <2.2, 1.1, 0>, 1 texture { Plain normal { wrinkles } } }
sphere { <-2.2, -1.1, 0>, 1 texture { Plain normal { granite 0.2 } scale 0.5 } }
sphere { <0, -1.1, 0>, 1 texture { gradient y texture_map { [0.4 Plain] [0.6 Plain normal { waves 0.5 frequency 4 }] } } }
#default { normal { wood 0.4 scale 0.3 } }
sphere { <2.2, -1.1, 0>, 1 texture { Plain } normal { bumps } }
