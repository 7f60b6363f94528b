// All interpolations, with and without once, over borders and alpha.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "panels.inc"
#for (I, 2, 4)
  Panel(pigment { image_map { png "rgb.png" interpolate I } })
  Panel(pigment { image_map { png "rgba.png" interpolate I once } scale 0.8 translate 0.1 })
  Panel(pigment { image_map { png "palette_alpha.png" interpolate I } scale <3, 3, 1> translate -0.4 })
  Panel(pigment { image_map { png "rgba.png" premultiplied 1 interpolate I } scale 2 })
  Panel(pigment { image_map { exr "floats.exr" interpolate I } scale 3 })
#end
Panel(pigment { image_map { png "grey16.png" interpolate 2 } scale 5 })
Panel(pigment { image_map { png "rgb.png" interpolate 2 } scale 0.31 translate 5.3 })
Panel(pigment { image_map { png "rgb.png" interpolate 4 } scale 40 translate <-3, 2, 0> })
Panel(pigment { image_map { gif "palette.gif" interpolate 3 } scale <-2, 1.5, 1> })
Panel(pigment { image_map { png "rgb.png" once } scale 0.5 translate 0.25 })
