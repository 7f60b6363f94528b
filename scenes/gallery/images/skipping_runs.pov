// Runs of a BMP file that skip pixels: these have the palette's last colour, and its index.
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 1 diffuse 0 } }
camera { orthographic location -z right 3 * x up y }
#macro T(C) texture { pigment { rgb C } } #end
box { <-1.5, -0.5, 0>, <-0.5, 0.5, 1> texture { material_map { bmp "skips.bmp" T(0) T(x) T(y) T(z) T(x + y) T(y + z) T(1) } translate -0.5 * (x + y) } }
box { <-0.5, -0.5, 0>, <0.5, 0.5, 1> pigment { image_map { bmp "skips.bmp" filter 15 0.5 } translate -0.5 * (x + y) } }
box { <0.5, -0.5, 0>, <1.5, 0.5, 1> pigment { image_map { bmp "skips_of_nibbles.bmp" } translate -0.5 * (x + y) } }
plane { -z, -4 pigment { checker rgb 1 rgb 0 scale 0.1 } }
