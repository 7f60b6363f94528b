// Some glyphs have parabolas whose control point lies on the chord, so that they are straight but for
// rounding: their walls stand where the chord is.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.6, 1.5, -3> look_at <0.75, 0.35, 0.3> angle 32 }
light_source { <4, 5, -4>, rgb 1 }
light_source { <-3, 1, -2>, rgb <0.4, 0.3, 0.5> }
plane { y, -0.2 pigment { checker rgb 0.9, rgb 0.5 scale 0.3 } }
#default { texture { pigment { rgb <0.9, 0.7, 0.3> } finish { specular 0.4 } } }
text { ttf "timrom.ttf" "&" 0.5, 0 rotate 40 * x translate <-0.3, 0, 0.1> }
text { ttf "timrom.ttf" "Q&" 0.3, 0 rotate <70, 0, 0> translate <0.3, 0, 0> }
text { ttf "timrom.ttf" "&" 1, 0 rotate <0, 40, 0> translate <1.2, 0, 1> }
text { ttf "crystal.ttf" "Q&" 0.3, 0 rotate <50, -20, 0> translate <0.1, 0.7, 0.6> }
