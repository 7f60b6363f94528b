// Mirrors of a sky that jumps at length 1: the last digit of every perturbed normal shows.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -3*z }
sky_sphere { pigment { onion color_map { [0 rgb <0.9, 0.5, 0.2>] [1 rgb <0.2, 0.4, 0.9>] } } }
#default { pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } }
sphere { <-0.9, 0.5, 0>, 0.5 normal { gradient x 0.5 scale 0.3 } }
sphere { <0.2, 0.5, 0>, 0.5 normal { gradient y normal_map { [0 gradient x 0.4] [1 crackle 0.5] } rotate 20 scale 0.7 } }
box { -0.4, 0.4 rotate <10, 20, 30> translate <1.3, 0.5, 0> normal { average normal_map { [1 gradient x] [2 gradient y] } scale 0.4 } }
plane { y, -0.7 normal { leopard 0.3 scale 0.1 } }
