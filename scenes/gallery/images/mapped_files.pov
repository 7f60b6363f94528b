// Palettes of Targa, BMP and GIF: colours, textures by index, heights by index, alpha.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "panels.inc"
#macro File(Name)
  #switch (asc(substr(Name, strlen(Name) - 2, 1)))
    #case (asc("t")) tga Name #break
    #case (asc("b")) bmp Name #break
    #else gif Name
  #end
#end
#macro Row(Name, Y)
  union {
    box { 0, 1 pigment { image_map { File(Name) } } }
    box { 0, 1 pigment { image_map { File(Name) interpolate 2 } } translate 1.1*x }
    box { 0, 1 texture { material_map { File(Name) texture { pigment { rgb x } } texture { pigment { rgb y } }
        texture { pigment { rgb z } } texture { pigment { rgb 1 } } } } translate 2.2*x }
    box { 0, 1 pigment { image_pattern { File(Name) use_alpha } } translate 3.3*x }
    height_field { File(Name) pigment { gradient y } rotate -90*x translate <4.4, 0, 1> }
    box { 0, 1 pigment { rgb 1 } normal { bump_map { File(Name) use_index bump_size 2 } }
      finish { ambient 0 diffuse 0.8 } translate 5.5*x }
    scale <0.75, 0.34, 1> translate Y*y
  }
#end
light_source { <-3, 9, -12>, 1 parallel point_at <2.5, 2, 0> }
Row("mapped.tga", 3.6)
Row("mapped_alpha.tga", 3.2)
Row("mapped_runs.tga", 2.8)
Row("words.tga", 2.4)
Row("words15.tga", 2.0)
Row("one_bit.bmp", 1.6)
Row("nibbles.bmp", 1.2)
Row("short_entries.bmp", 0.8)
Row("runs.bmp", 0.4)
Row("alpha.bmp", 0.0)
Row("interlaced.gif", -0.4)
