// Noise as a height: bozo, spotted, granite, agate, marble, wood.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <0.85, 0.8, 0.7> } finish { phong 0.4 phong_size 30 } }
sphere { 0, 0.95 normal { bozo 0.6 scale 0.2 } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 normal { spotted 0.8 scale 0.1 noise_generator 3 } translate <0, 1.15, 0> }
sphere { 0, 0.95 normal { granite 0.4 scale 0.5 } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 normal { agate 0.3 scale 0.3 } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 normal { marble 0.6 turbulence 0.6 scale 0.3 } translate <0, -1.15, 0> }
sphere { 0, 0.95 normal { wood 0.5 turbulence 0.1 scale 0.2 } translate <2.3, -1.15, 0> }
