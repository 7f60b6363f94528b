#version 3.7;
// Every antialiasing sample is a whole pixel of focal blur, its points chosen by its place.
global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> right 4/3*x angle 45 look_at <0, 0.3, 0> aperture 0.3 focal_point 0 blur_samples 7, 12 variance 0.001 }
light_source { <4, 6, -5>, rgb 1 }
plane { y, -0.5 pigment { checker rgb 0.9, rgb <0.1, 0.2, 0.3> scale 0.5 } }
sphere { <-0.7, 0.1, -1>, 0.5 pigment { rgb <0.8, 0.3, 0.1> } }
sphere { <0.7, 0.3, 1.5>, 0.7 pigment { rgb <0.2, 0.4, 0.8> } finish { reflection 0.2 } }
