// TIFF: bits, alpha of three kinds, orientation, palettes whose entries change; interpolation, patterns.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "panels.inc"
Panel(pigment { image_map { tiff "grey.tif" } })
Panel(pigment { image_map { tiff "grey_white.tif" } })
Panel(pigment { image_map { tiff "grey16.tif" interpolate 2 } })
Panel(pigment { image_map { tiff "grey_signed.tif" } })
Panel(pigment { image_map { tiff "grey_straight.tif" } })
Panel(pigment { image_map { tiff "grey_associated.tif" interpolate 3 } })
Panel(pigment { image_map { tiff "grey_unknown.tif" } })
Panel(pigment { image_map { tiff "packbits.tif" gamma srgb } })
Panel(pigment { image_map { tiff "deflate16.tif" } })
Panel(pigment { image_map { tiff "associated.tif" interpolate 4 } })
Panel(pigment { image_map { tiff "unknown.tif" } })
Panel(pigment { image_map { tiff "straight16.tif" } })
Panel(pigment { image_map { tiff "five.tif" premultiplied 0 } })
Panel(pigment { image_map { tiff "turned.tif" } })
Panel(pigment { image_map { tiff "palette.tif" } })
Panel(pigment { image_map { tiff "palette.tif" transmit 1, 0.6 filter 3, 0.5 } })
Panel(pigment { image_map { tiff "palette_bytes.tif" gamma 1.8 interpolate 2 } })
Panel(pigment { image_pattern { tiff "grey_straight.tif" use_alpha } })
Panel(pigment { image_pattern { tiff "packbits.tif" use_alpha } })
Panel(pigment { image_pattern { tiff "palette.tif" use_alpha } })
