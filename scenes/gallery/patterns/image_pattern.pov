// image_pattern: interpolation, once, map types, alpha.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1.5, 1.0, -20> direction 20 * z up 2.25 * y right 3 * x look_at <1.5, 1.0, 0> }
#default { finish { ambient 1 diffuse 0 } }
#declare Ramp = color_map { [0 rgb <0.05, 0.05, 0.15>] [0.5 rgb <0.9, 0.5, 0.2>] [1 rgb <1, 1, 0.85>] }
// Squares seen from the front, one pigment each.
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { image_pattern { ppm "a.ppm" } color_map { Ramp } } translate <0, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { image_pattern { ppm "a.ppm" interpolate 2 } color_map { Ramp } } translate <1, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { image_pattern { ppm "a.ppm" interpolate 3 once offset <0.2, 0.3> } color_map { Ramp } } translate <2, 1, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { image_pattern { png "rgba.png" use_alpha interpolate 4 } color_map { Ramp } } translate <0, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { image_pattern { png "pal.png" map_type 1 interpolate 2 } color_map { Ramp } translate 0.5 } translate <1, 0, 0> }
box { <0.03, 0.03, 0.07>, <0.97, 0.97, 1> pigment { image_pattern { png "g8.png" map_type 2 repeat <3, 2> } frequency 2 color_map { Ramp } rotate 90*x translate 0.5 } translate <2, 0, 0> }
