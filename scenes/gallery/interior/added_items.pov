// A second interior{} or material{} of an object adds to what the first one said: further items,
// a further layer. A named interior replaces it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -8> look_at 0 angle 50 }
light_source { <-7, 9, -11> rgb 1 }
plane { z, 2.5 pigment { checker rgb 0.9, rgb <0.2, 0.3, 0.7> scale 0.7 } }
#declare Fading = interior { fade_distance 1 fade_power 1 fade_color <0.9, 0.5, 0.3> }
#declare Clear = texture { pigment { rgbf <0.9, 1, 0.9, 0.9> } finish { phong 0.5 } }
#declare Stripes = texture {
  pigment { gradient y color_map { [0.5 rgbf <1, 0.6, 0.5, 0.8>] [0.5 rgbt <1, 1, 1, 1>] } scale 0.5 }
}
#declare Glass = sphere { 0, 1 texture { Clear } interior { ior 1.5 } }
object { Glass interior { fade_distance 1 fade_power 1 fade_color <0.9, 0.5, 0.3> } translate <-2.6, 1.3, 0> }
object { Glass interior { Fading } translate <0, 1.3, 0> }
object { Glass material { texture { Stripes } interior { fade_distance 2 fade_power 2 } } translate <2.6, 1.3, 0> }
#declare Striped = material { texture { Stripes } interior { ior 1.2 } }
object { Glass material { Striped } translate <-2.6, -1.2, 0> }
sphere { 0, 1 texture { Clear } material { Striped interior { dispersion 1.05 fade_distance 1 fade_power 2 } }
  translate <0, -1.2, 0> }
#declare Unfilled = material { texture { Stripes } }
object { Glass material { Unfilled } scale 0.5 translate <-1.3, 0, -1> }
sphere { 0, 1 interior { ior 1.4 } material { texture { Clear } interior { caustics 0.8 } }
  translate <2.6, -1.2, 0> }
