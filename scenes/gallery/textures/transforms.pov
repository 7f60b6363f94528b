// Transforms inside texture{} act on the parts before them; those of objects on all.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
sphere { 0, 0.95 texture { pigment { checker scale 0.3 } rotate 45*z normal { gradient x 0.5 sine_wave scale 0.2 } } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 texture { pigment { checker scale 0.3 } normal { gradient x 0.5 sine_wave scale 0.2 } rotate 45*z } translate <0, 1.15, 0> }
sphere { 0, 0.95 pigment { checker scale 0.3 } scale <1, 0.5, 1> rotate 30*z translate <2.3, 1.15, 0> }
sphere { 0, 0.95 scale <1, 0.5, 1> rotate 30*z pigment { checker scale 0.3 } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 texture { gradient x texture_map { [0.5 pigment { checker scale 0.2 }] [0.5 pigment { rgb 1 } normal { bumps 1 scale 0.2 }] } rotate 30*z scale 0.5 } translate <0, -1.15, 0> }
sphere { 0, 0.95 material { texture { pigment { wood scale 0.2 } } interior { ior 1.2 } rotate <60, 30, 0> scale 0.5 } translate <2.3, -1.15, 0> }
