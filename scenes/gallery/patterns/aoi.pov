// aoi: the angle between ray and normal; in a mirror the ray is another one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -9> look_at <0, 0.3, 0> angle 42 }
light_source { <-5, 8, -10> rgb 0.6 }
#default { finish { ambient 0.6 diffuse 0.5 } }
#declare Ramp = color_map { [0.5 rgb <0.1, 0.1, 0.4>] [0.7 rgb <0.2, 0.7, 0.3>] [0.9 rgb <1, 0.9, 0.4>] [1 rgb 1] }
plane { y, -1 pigment { rgb 0.2 } finish { reflection 0.7 } }
sphere { <-2.2, 0.3, 0>, 1 pigment { aoi color_map { Ramp } } }
sphere { <0, 0.3, 0>, 1 pigment { aoi color_map { Ramp } } normal { bumps 0.5 scale 0.2 } }
torus { 0.8, 0.35 pigment { aoi frequency 4 triangle_wave color_map { Ramp } } rotate 50*x translate <2.4, 0.3, 0> }
box { <-3, -1, 3>, <3, 0.5, 3.2> pigment { aoi color_map { Ramp } } rotate 10*y }
