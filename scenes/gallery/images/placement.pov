// repeat, offset, once, transforms and warps of an image.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "panels.inc"
#macro I(S) image_map { png "rgb.png" S } #end
Panel(pigment { image_map { png "rgb.png" repeat <2, 3> } })
Panel(pigment { image_map { png "rgb.png" repeat <0.5, 2> once } })
Panel(pigment { image_map { png "rgb.png" offset <0.3, 0.1> } })
Panel(pigment { image_map { png "rgb.png" offset <0.3, 0.1> once } })
Panel(pigment { image_map { png "rgb.png" offset <-0.3, -2.1> repeat 2 once } })
Panel(pigment { image_map { png "rgb.png" } rotate 30*z scale 0.6 })
Panel(pigment { image_map { png "rgb.png" } warp { turbulence 0.3 octaves 3 } })
Panel(pigment { image_map { png "rgb.png" } warp { black_hole <0.5, 0.5, 0>, 0.5 strength 1.2 } })
Panel(pigment { image_map { png "rgb.png" } warp { repeat 0.5*x flip x } scale <0.6, 1, 1> })
Panel(pigment { image_map { png "rgb.png" } translate <0.37, -0.2, 0> scale -1 })
Panel(pigment { checker pigment { image_map { png "rgb.png" } scale 0.25 } pigment { image_map { gif "palette.gif" } scale 0.2 } scale 0.25 })
Panel(pigment { gradient x pigment_map { [0 image_map { png "rgb.png" }] [1 image_map { png "rgba.png" }] } })
Panel(pigment { average pigment_map { [2 image_map { png "rgb.png" }] [1 rgb <0, 0, 1>] } })
Panel(pigment { image_map { png "rgb.png" once } scale 0.5 })
Panel(pigment { image_map { png "rgb.png" } quick_color rgb 1 })
box { <0, 0, 0>, <1, 1, 0.01> texture { pigment { image_map { png "grey.png" } } }
  texture { pigment { image_map { png "rgba.png" interpolate 2 } scale 0.7 } } }
box { <1, 0, 0>, <1.9, 0.9, 0.01> texture { uv_mapping pigment { image_map { png "rgb.png" } } } }
sphere { <2.5, 0.5, 0>, 0.45 pigment { uv_mapping image_map { png "rgb.png" interpolate 2 } } }
mesh { triangle { <3, 0, 0>, <4, 0, 0>, <3.5, 0.9, 0> uv_vectors <0, 0>, <2, 0>, <1, 1> }
  pigment { uv_mapping image_map { png "rgb.png" } } }
disc { <4.5, 0.5, 0>, z, 0.45 pigment { image_map { png "rgb.png" interpolate 2 } translate <0.5, 0.5, 0> } }
