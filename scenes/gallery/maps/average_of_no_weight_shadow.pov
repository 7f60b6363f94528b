// Averages whose weights sum to 0 are no numbers: their surfaces are black and stop a light, while
// lights without shadows go on.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.8 }
light_source { <6, 5, -10> rgb 0.3 shadowless }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.2, 0.3, 0.7> } }
sphere { <-2, 0, 0>, 0.9 pigment { average pigment_map { [0 rgbt <1, 0, 0, 0.5>] [0 rgb 1] } } }
sphere { <0, 0, 0>, 0.9 pigment { average pigment_map { [1 rgbf <1, 0.5, 0, 0.9>] [-1 rgbf <1, 0.5, 0, 0.9>] } } }
sphere { <2, 0, 0>, 0.9 pigment { average pigment_map { [1 rgbf <1, 0.5, 0, 0.9>] [-1 rgbf <0.4, 0.5, 0, 0.7>] } } }
