// OpenEXR: channels and their types, compressions, windows; values are those of half floats.
#version 3.7;
global_settings { assumed_gamma 1.0 }
#include "panels.inc"
Panel(pigment { image_map { exr "none.exr" } })
Panel(pigment { image_map { exr "zips.exr" interpolate 2 } })
Panel(pigment { image_map { exr "zip_float.exr" } })
Panel(pigment { image_map { exr "rgba_mixed.exr" } })
Panel(pigment { image_map { exr "grey.exr" } })
Panel(pigment { image_map { exr "grey_alpha.exr" interpolate 3 } })
Panel(pigment { image_map { exr "chroma.exr" } })
Panel(pigment { image_map { exr "red.exr" } })
Panel(pigment { image_map { exr "layer.exr" } })
Panel(pigment { image_map { exr "unsigned.exr" } })
Panel(pigment { image_map { exr "negative.exr" } })
Panel(pigment { image_map { exr "window.exr" interpolate 4 } })
Panel(pigment { image_map { exr "zip_float.exr" transmit all 0.4 } })
Panel(pigment { image_map { exr "rgba_mixed.exr" premultiplied 0 interpolate 2 } })
Panel(pigment { image_map { exr "grey_alpha.exr" gamma 1.8 } })
Panel(pigment { image_pattern { exr "rgba_mixed.exr" use_alpha } })
Panel(pigment { image_pattern { exr "none.exr" use_alpha } })
Panel(pigment { image_pattern { exr "grey.exr" use_alpha } })
Panel(pigment { image_pattern { exr "grey_alpha.exr" } })
Panel(pigment { image_pattern { exr "chroma.exr" } })
