// image_pattern: grey, alpha, palettes, gamma, interpolation, maps and waves on top.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "panels.inc"
#macro Colors() color_map { [0 rgb 0] [0.4 rgb <1, 0.2, 0>] [0.7 rgb <1, 1, 0.2>] [1 rgb <0.7, 0.9, 1>] } #end
Panel(pigment { image_pattern { png "rgb.png" } Colors() })
Panel(pigment { image_pattern { png "grey.png" interpolate 2 } Colors() })
Panel(pigment { image_pattern { png "grey16.png" interpolate 3 } Colors() })
Panel(pigment { image_pattern { png "rgba.png" use_alpha } Colors() })
Panel(pigment { image_pattern { png "rgb.png" use_alpha } Colors() })
Panel(pigment { image_pattern { png "palette.png" } Colors() })
Panel(pigment { image_pattern { png "palette.png" use_index } Colors() })
Panel(pigment { image_pattern { png "palette_alpha.png" use_alpha } Colors() })
Panel(pigment { image_pattern { png "palette.png" use_alpha } Colors() })
Panel(pigment { image_pattern { gif "palette.gif" use_color interpolate 2 } Colors() })
Panel(pigment { image_pattern { gif "palette.gif" use_alpha } Colors() })
Panel(pigment { image_pattern { png "grey_alpha.png" use_alpha interpolate 4 } Colors() })
Panel(pigment { image_pattern { png "rgb.png" gamma 2.2 } Colors() })
Panel(pigment { image_pattern { exr "floats.exr" use_alpha } Colors() })
Panel(pigment { image_pattern { hdr "floats.hdr" } Colors() })
Panel(pigment { image_pattern { png "rgb.png" once } Colors() scale 0.6 })
Panel(pigment { image_pattern { png "rgb.png" map_type 1 } Colors() translate <0.5, 0.5, 0.3> })
Panel(pigment { image_pattern { png "grey16.png" interpolate 2 } Colors() sine_wave frequency 3 })
Panel(pigment { image_pattern { tiff "rgba.tif" use_alpha } Colors() })
Panel(pigment { image_pattern { function 16, 16 { x*y } } Colors() })
