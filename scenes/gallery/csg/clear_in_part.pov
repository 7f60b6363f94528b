// Spheres whose pattern is clear in part, in an intersection whose own texture is opaque.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.4, -5> look_at <0, 0.1, 0> angle 42 }
light_source { <-5, 8, -6> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.6 } }
intersection {
  sphere { <-0.3, 0, 0>, 1 pigment { bozo color_map { [0.45 rgb <0.8, 0.2, 0.1>] [0.55 rgbf <0.6, 0.4, 0.6, 0.9>] } scale 0.3 } }
  sphere { <0.3, 0, 0>, 1 pigment { checker rgb <0.1, 0.3, 0.8>, rgbt <0.5, 0.6, 0.9, 0.7> scale 0.3 } }
  pigment { rgb 1 }
}
