// interior_texture: the side seen from inside.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
sphere { 0, 0.95 clipped_by { plane { <-1, 0, 0.8>, 0.2 inverse } } texture { pigment { rgb <1, 0.7, 0.4> } } interior_texture { pigment { checker rgb 1, rgb <0, 0.3, 0.6> scale 0.2 } } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 clipped_by { plane { <-1, 0, 0.8>, 0.2 inverse } } texture { pigment { bozo scale 0.2 } } interior_texture { pigment { rgb <1, 0, 0> } normal { bumps 1 scale 0.1 } finish { phong 1 } } rotate 40*z translate <0, 1.15, 0> }
sphere { 0, 0.95 clipped_by { plane { <-1, 0, 0.8>, 0.2 inverse } } texture { pigment { checker rgbt 1, rgb 1 scale 0.3 } } interior_texture { pigment { gradient y scale 0.2 } } scale <1, 0.7, 1> translate <2.3, 1.15, 0> }
