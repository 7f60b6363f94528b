// Heights from floats, whose red and green count like bytes and wrap above 1, and from kinds of TIFF.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { orthographic location <1.5, 4, -3> look_at <1.5, 0, 1> right 4.2*x up 3.2*y }
light_source { <-20, 40, -30> rgb 1 }
background { rgb <0.1, 0.15, 0.3> }
#default { pigment { rgb <0.9, 0.7, 0.4> } finish { ambient 0.2 diffuse 0.8 } }
#macro Field(F, X, Z) object { F scale <0.94, 0.4, 0.94> translate <X, 0, Z> } #end
Field(height_field { exr "zip_float.exr" }, 0, 1)
Field(height_field { hdr "floats.hdr" }, 1, 1)
Field(height_field { exr "grey.exr" smooth }, 2, 1)
Field(height_field { tiff "grey16.tif" }, 0, 0)
Field(height_field { tiff "palette.tif" }, 1, 0)
Field(height_field { tiff "deflate16.tif" }, 2, 0)
