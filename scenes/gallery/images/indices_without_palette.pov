// Interpolated indices of pictures without a palette: bump_map counts three or none; material_map rounds down.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "panels.inc"
light_source { <-3, 9, -12>, 1 parallel point_at <2.5, 2, 0> }
#macro B(N)
  box { 0, <0.94, 0.94, 0.01> pigment { rgb <0.9, 0.7, 0.4> } normal { N scale <0.94, 0.94, 1> } finish { ambient 0.1 diffuse 0.8 }
    translate <mod(Panel_Number, 5), 3 - div(Panel_Number, 5), 0> }
  #declare Panel_Number = Panel_Number + 1;
#end
#macro M(T)
  box { 0, <0.94, 0.94, 0.01> texture { T translate <0.5, 0.45, 0.3> }
    translate <mod(Panel_Number, 5), 3 - div(Panel_Number, 5), 0> }
  #declare Panel_Number = Panel_Number + 1;
#end
#declare Kind = 0;
#while (Kind < 6)
  #if (Kind != 3 & Kind != 4)
    #declare Way = 2;
    #while (Way < 5)
      B(normal { bump_map { png "grey.png" interpolate Way map_type Kind use_index bump_size 2 } translate <0.3, 0.45, 0.2> })
      #declare Way = Way + 1;
    #end
    M(texture { material_map { png "grey16.png" interpolate 4 map_type Kind
      texture { pigment { rgb x } finish { ambient 1 diffuse 0 } } texture { pigment { rgb y } finish { ambient 1 diffuse 0 } } texture { pigment { rgb z } finish { ambient 1 diffuse 0 } } } })
  #end
  #declare Kind = Kind + 1;
#end
