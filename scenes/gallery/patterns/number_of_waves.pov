// number_of_waves in global_settings: ripples and waves of three sources.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.0, 0.5, -20> direction 20 * z up 1.5 * y right 2 * x look_at <1.0, 0.5, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
global_settings { number_of_waves 3 }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { ripples color_map { Ramp } scale 0.2 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { waves color_map { Ramp } scale 0.1 } translate <1, 0, 0> }
