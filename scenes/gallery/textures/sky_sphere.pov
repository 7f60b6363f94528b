// sky_sphere: layers, transforms that shift the direction, emission.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -4> look_at <0, 1.6, 0> angle 80 }
light_source { <-5, 8, -10> rgb 0.9 }
background { rgb <0.3, 0, 0.3> }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <1, 0.8, 0.6>] [0.4 rgb <0.2, 0.4, 0.9>] [1 rgbt <0, 0, 0.3, 0.2>] } }
  pigment { bozo turbulence 0.6 color_map { [0.45 rgbt 1] [0.7 rgbf <1, 1, 0.9, 0.3>] } scale <0.4, 0.1, 0.4> }
  emission rgb <0.9, 1, 0.8>
  rotate 20*z translate <0.1, -0.1, 0>
}
sphere { <-1, 1, 0>, 0.8 pigment { rgb 0.1 } finish { reflection 0.8 } }
sphere { <1, 1, 0>, 0.8 pigment { rgbf 0.9 } interior { ior 1.3 } }
