// function, pigment_pattern, image_pattern, density_file, julia, tiling.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <0.85, 0.8, 0.7> } finish { phong 0.4 phong_size 30 } }
sphere { 0, 0.95 normal { function { sin(x * 9) * 0.3 + z * z } 0.7 } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 normal { pigment_pattern { bozo scale 0.2 } 0.6 } translate <0, 1.15, 0> }
sphere { 0, 0.95 normal { image_pattern { ppm "a.ppm" interpolate 2 } 0.7 scale 0.5 } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 normal { density_file df3 "d1.df3" 0.8 interpolate 1 scale 2 translate -1 } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 normal { julia <0.353, 0.288>, 20 0.3 } translate <0, -1.15, 0> }
sphere { 0, 0.95 normal { tiling 7 0.4 scale 0.2 rotate 90*x } translate <2.3, -1.15, 0> }
