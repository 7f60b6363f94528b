// crand: grain; random in POV-Ray, too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
sphere { 0, 0.95 pigment { rgb <1, 0.8, 0.5> } finish { crand 0.3 } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 pigment { rgb <0.5, 0.7, 1> } finish { crand 0.1 diffuse 0.8 } translate <0, 1.15, 0> }
