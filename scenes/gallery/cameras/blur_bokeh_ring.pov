#version 3.7;
// A ring, by a spherical pattern; grey values of a colour.
#include "surroundings.inc"

camera { location <0.4, 0.8, -5> right 4/3*x angle 50 look_at <0.3, 0.1, 3> aperture 2 blur_samples 40 focal_point <0, 0, 8> bokeh { pigment { cylindrical rotate x*90 translate <0.5, 0.5, 0> scale 0.9 color_map { [0.2 rgb 0] [0.3 rgb <0.4, 0.9, 0.6>] [0.6 rgb <0.4, 0.9, 0.6>] [0.7 rgb 0] } } } }
