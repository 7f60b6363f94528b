#version 3.7;
// A colour on half of the lens only.
#include "surroundings.inc"

camera { location <0.4, 0.8, -5> right 4/3*x angle 50 look_at <0.3, 0.1, 3> aperture 2 blur_samples 30 focal_point <0, 0, 8> variance 0 bokeh { pigment { gradient x color_map { [0.5 rgb 0] [0.5 rgb 1] } } } }
