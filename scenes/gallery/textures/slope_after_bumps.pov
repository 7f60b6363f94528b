// Entries of a texture_map that are blended: the lower one is chosen by the slope of the normal that
// the upper one left bumped.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.2, -4.5> look_at <0, 0.4, 0> angle 45 }
light_source { <-6, 9, -8> rgb 1 }
#declare Grass = texture { pigment { rgb <0.2, 0.5, 0.1> } normal { bumps 0.8 scale 0.05 } }
#declare Soil = texture { pigment { rgb <0.7, 0.5, 0.3> } }
#declare Rock = texture { pigment { rgb 0.5 } normal { wrinkles 0.6 scale 0.2 } }
#declare Land = texture {
  slope { -y * 2, 0, 0.7 }
  texture_map { [0.4 Grass] [0.5 Soil] [0.7 Soil] [0.7 Rock] }
}
sphere { <-0.9, 0.7, 0>, 0.9 texture { gradient y scale 2.5 texture_map { [0 Soil] [0.2 Land] [1 Land] } } }
box {
  -0.6, 0.6
  rotate <20, 35, 10>
  translate <1, 0.7, 0>
  texture { average texture_map { [1 Land] [2 Rock] [1 Land] } }
}
plane { y, -0.2 texture { bozo scale 0.6 texture_map { [0 Land] [1 Land rotate 90 * x] } } }
