// boxed, spherical, cylindrical, planar: 1 in the middle, 0 from distance 1.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.0, -20> direction 20 * z up 2.25 * y right 3 * x look_at <1.5, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { boxed color_map { Ramp } scale 0.45 translate 0.5 } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { spherical color_map { Ramp } scale 0.45 translate 0.5 } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { cylindrical color_map { Ramp } rotate 90*x scale 0.45 translate 0.5 } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { planar color_map { Ramp } scale 0.45 translate 0.5 } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { boxed frequency 4 color_map { Ramp } rotate 30*z scale 0.5 translate 0.5 } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { spherical turbulence 0.5 poly_wave 2 color_map { Ramp } scale 0.6 translate 0.5 } translate <2, 0, 0> }
