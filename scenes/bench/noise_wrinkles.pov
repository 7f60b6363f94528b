// A plane with wrinkles: ten vector noises per pixel.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at <0, 0.6, 0> }
light_source { <10, 20, -15> rgb 1 }
plane { y, 0 pigment { rgb <0.9, 0.8, 0.6> } normal { wrinkles 0.7 scale 0.5 } }
