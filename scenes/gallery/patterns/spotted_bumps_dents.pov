// spotted, bumps and dents as pigments.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 1.0, -20> direction 20 * z up 2 * y right 2.66667 * x look_at <1.0, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { spotted color_map { Ramp } scale 0.15 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { bumps color_map { Ramp } scale 0.15 noise_generator 1 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { dents color_map { Ramp } scale 0.15 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { dents noise_generator 3 sine_wave frequency 2 color_map { Ramp } scale 0.15 } translate <1, 0, 0> }
