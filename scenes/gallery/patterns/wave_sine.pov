// sine_wave: on gradient, bozo, wood and marble; with frequency, phase and negative values.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.0, -20> direction 20 * z up 2.25 * y right 3 * x look_at <1.5, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x sine_wave color_map { Ramp } scale 0.4 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { gradient x sine_wave frequency -2 phase 0.3 color_map { Ramp } } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { bozo sine_wave frequency 3 color_map { Ramp } scale 0.15 } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { wood sine_wave phase 0.2 color_map { Ramp } scale 0.2 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { marble turbulence 0.5 sine_wave color_map { Ramp } scale 0.3 } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { function { x * 3 - 1.5 } sine_wave frequency 0 color_map { Ramp } } translate <2, 0, 0> }
