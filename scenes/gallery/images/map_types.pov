// Planar, spherical, cylindrical and toroidal maps, with repeat, offset and once.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { location <0, 1.5, -7> look_at 0 angle 60 }
light_source { <-5, 8, -10>, 1 }
background { rgb 0.2 }
#macro M(T) image_map { png "rgb.png" map_type T interpolate 2 } #end
sphere { 0, 1 pigment { M(1) } translate <-2.4, 1.4, 0> }
cylinder { 0, y, 1 pigment { M(2) } translate <0, 0.8, 0> }
torus { 1, 0.4 pigment { M(5) } rotate -50*x translate <2.6, 1.4, 0> }
box { 0, 1 pigment { M(0) } rotate 20*y translate <-3, -1.6, 0> }
sphere { 0, 1 pigment { image_map { gif "palette.gif" map_type 1 repeat <3, 2> offset <0.1, 0.3> } }
  rotate 130*y translate <-0.8, -1.2, 0> }
cylinder { -y, y, 0.6 pigment { image_map { png "rgba.png" map_type 2 once repeat <1, 1> offset <0.2, 0> } }
  rotate <20, -70, 0> translate <1.2, -1.2, 0> }
torus { 0.7, 0.4 pigment { image_map { png "rgb.png" map_type 5 repeat <4, 2> } scale <0.7, 0.7, 0.7> }
  rotate -70*x translate <3, -1.4, 0> }
