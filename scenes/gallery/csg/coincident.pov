// Coincident faces of different objects: the order of tests decides, with povray's grain.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 4, -9> look_at <0, 0, 0> angle 50 }
light_source { <-5, 8, -10> rgb 0.9 }
background { rgb <0.15, 0.2, 0.3> }
#declare A = texture { pigment { rgb <1, 0.4, 0.3> } }
#declare B = texture { pigment { rgb <0.3, 0.5, 1> } }
box { <-4, -0.5, -3>, <4, 0, 3> texture { A } }
#for (I, 0, 3)
  #for (J, 0, 2)
    box { <2*I-4, -2, 2*J-3>, <2*I-3, 0, 2*J-2> texture { B } }
  #end
#end
plane { z, 5 texture { A } }
plane { z, 5 texture { B } }
sphere { <0, 2, 0>, 0.7 texture { A } }
sphere { <0, 2, 0>, 0.7 texture { B } }
