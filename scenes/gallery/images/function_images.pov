// Images made of functions: numbers and pigments, every use.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "panels.inc"
#declare F = function(x, y, z) { 0.5 + 0.5*sin(12*x)*cos(9*y) }
#declare P = pigment { bozo color_map { [0 rgb x] [0.5 rgbt <0, 1, 0, 0.3>] [1 rgb <0.2, 0.3, 1>] } scale 0.2 }
Panel(pigment { image_map { function 20, 14 { F(x, y, z) } } })
Panel(pigment { image_map { function 20, 14 { F(x, y, z) } interpolate 2 } })
Panel(pigment { image_map { function 40, 30 { pigment { P } } } })
Panel(pigment { image_map { function 40, 30 { pigment { agate scale 0.3 } } interpolate 3 once } scale 0.8 })
Panel(pigment { image_map { function 3, 2 { x*y } } })
Panel(pigment { image_map { function 20, 20 { 1.4*x - 0.2 } } })
Panel(pigment { image_pattern { function 20, 20 { F(x, y, z) } interpolate 2 } color_map { [0 rgb x] [1 rgb z] } })
Panel(pigment { image_map { function 30, 30 { pattern { marble turbulence 0.5 scale 0.3 } } transmit all 0.3 } })
Panel(pigment { image_map { function 1, 1 { 0.5 } } })
Panel(pigment { image_map { function 20, 14 { F(x, y, z) } map_type 1 } translate <0.5, 0.5, 0.3> })
#declare Picture = pigment { image_map { png "rgb.png" } };
#declare Size = max_extent(Picture);
#debug concat("size ", vstr(3, Size, " ", 0, 0), "\n")
Panel(pigment { image_map { png "rgb.png" interpolate 2 } scale <Size.x/20, Size.y/14, 1> })
