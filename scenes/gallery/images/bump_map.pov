// bump_map from colours, palettes, grey and 16 bits; interpolation, size, once.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "panels.inc"
light_source { <-3, 9, -12>, 1 parallel point_at <2.5, 2, 0> }
#macro B(N)
  box { 0, <0.94, 0.94, 0.01> pigment { rgb <0.9, 0.7, 0.4> } normal { N scale <0.94, 0.94, 1> } finish { ambient 0.1 diffuse 0.8 phong 0.5 }
    translate <mod(Panel_Number, 5), 3 - div(Panel_Number, 5), 0> }
  #declare Panel_Number = Panel_Number + 1;
#end
B(normal { bump_map { png "rgb.png" bump_size 2 } })
B(normal { bump_map { png "rgb.png" interpolate 2 bump_size 2 } })
B(normal { bump_map { png "rgb.png" interpolate 3 bump_size 2 } })
B(normal { bump_map { png "rgb.png" interpolate 4 bump_size 2 } })
B(normal { bump_map { png "grey16.png" interpolate 2 bump_size 5 } })
B(normal { bump_map { png "palette.png" bump_size 2 } })
B(normal { bump_map { png "palette.png" interpolate 2 use_index bump_size 20 } })
B(normal { bump_map { gif "palette.gif" interpolate 2 use_color bump_size 2 } })
B(normal { bump_map { gif "palette.gif" interpolate 2 use_index bump_size 2 } })
B(normal { bump_map { tga "rgb.tga" interpolate 2 once bump_size 3 } scale 0.6 })
B(normal { bump_map { ppm "rgb16.ppm" interpolate 2 } scale <0.5, 0.5, 1> })
B(normal { bump_map { pgm "grey.pgm" interpolate 2 bump_size -3 } })
B(normal { bump_map { jpeg "rgb.jpg" gamma 2.2 interpolate 2 bump_size 3 } })
B(normal { bump_map { png "rgba.png" interpolate 2 bump_size 3 } })
B(normal { bump_map { png "rgb_srgb.png" interpolate 2 bump_size 3 map_type 1 } translate <-0.5, -0.5, 0.2> })
B(normal { bump_map { hdr "floats.hdr" interpolate 2 bump_size 1 } })
B(normal { bump_map { function 30, 30 { pattern { crackle scale 0.2 } } interpolate 2 bump_size 3 } })
B(normal { average normal_map { [1 bump_map { png "rgb.png" interpolate 2 bump_size 3 }] [1 bumps scale 0.1] } })
B(normal { bump_map { png "grey.png" interpolate 2 bump_size 3 } rotate 30*z })
B(normal { bump_map { png "palette_alpha.png" interpolate 2 bump_size 2 repeat <2, 2> offset <0.2, 0> } })
