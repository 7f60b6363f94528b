// bump_map: interpolation, once, use_index, bump_size.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <0.85, 0.8, 0.7> } finish { phong 0.4 phong_size 30 } }
sphere { 0, 0.95 normal { bump_map { pgm "bump.pgm" bump_size 3 interpolate 2 } } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 normal { bump_map { pgm "bump.pgm" map_type 1 bump_size 3 interpolate 3 } } translate <0, 1.15, 0> }
sphere { 0, 0.95 normal { bump_map { png "pal.png" use_index bump_size 0.5 interpolate 2 } scale 0.5 } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 normal { bump_map { pgm "bump.pgm" once interpolate 2 bump_size 2 } scale 1.2 translate -0.6 } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 normal { bump_map { ppm "a.ppm" map_type 2 interpolate 4 } bump_size 3 scale 0.5 } translate <0, -1.15, 0> }
sphere { 0, 0.95 normal { bump_map { pgm "bump.pgm" interpolate 2 bump_size 2 } rotate 90*x scale <0.5, 1, 0.7> } translate <2.3, -1.15, 0> }
