// filter and transmit: all and by palette index, on colours, palettes and alpha.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "panels.inc"
Panel(pigment { image_map { png "rgb.png" transmit all 0.5 } })
Panel(pigment { image_map { png "rgb.png" filter all 0.5 } })
Panel(pigment { image_map { png "rgba.png" transmit all 0.3 } })
Panel(pigment { image_map { png "rgba.png" filter all 0.3 } })
Panel(pigment { image_map { png "palette.png" transmit all 0.5 } })
Panel(pigment { image_map { png "palette.png" filter all 0.8 } })
Panel(pigment { image_map { png "palette.png" transmit 0, 1 transmit 3, 0.5 } })
Panel(pigment { image_map { png "palette.png" filter 1 1 filter 2 0.5 } })
Panel(pigment { image_map { png "palette_alpha.png" transmit all 0.5 } })
Panel(pigment { image_map { png "palette_alpha.png" filter all 0.5 } })
Panel(pigment { image_map { png "palette_alpha.png" transmit 1 0 filter 4 1 } })
Panel(pigment { image_map { gif "palette.gif" transmit 5, 1 filter 0, 1 interpolate 2 } })
Panel(pigment { image_map { gif "palette.gif" filter all 0.6 transmit 1, 1 transmit all 0.2 } })
Panel(pigment { image_map { png "grey_alpha.png" filter all 0.4 interpolate 2 } })
Panel(pigment { image_map { tiff "rgba.tif" transmit all 0.4 } })
Panel(pigment { image_map { png "grey.png" filter all 1 } })
Panel(pigment { image_map { tga "rgba.tga" interpolate 2 } })
Panel(pigment { image_map { exr "floats.exr" transmit all 0.2 } })
Panel(pigment { image_map { png "rgba16.png" premultiplied 1 filter all 0.2 } })
Panel(pigment { image_map { png "rgb_key.png" interpolate 3 } })
