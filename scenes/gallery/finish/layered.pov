// Layers: each filters what lies below; all of them are lit, shine and mirror.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
sphere {
  <-1.3, 0.6, 0>, 0.6
  texture { pigment { rgb <0.8, 0.3, 0.2> } finish { reflection 0.3 } }
  texture { pigment { bozo color_map { [0.4 rgbt 1] [0.6 rgbf <0.5, 0.9, 0.5, 0.6>] } scale 0.3 } finish { phong 0.8 } }
}
sphere {
  <0, 0.6, 0>, 0.6
  texture { pigment { checker rgb <0.9, 0.8, 0.2> rgb <0.2, 0.2, 0.6> scale 0.3 } }
  texture { pigment { rgbft <0.5, 0.7, 1, 0.5, 0.2> } finish { ambient 0 specular 1 roughness 0.01 } }
  texture { pigment { rgbt <1, 1, 1, 0.9> } finish { reflection { 0.1, 0.8 } } }
}
sphere {
  <1.3, 0.6, 0>, 0.6
  texture { pigment { rgb <0.3, 0.7, 0.9> } normal { bumps 0.8 scale 0.1 } finish { reflection 0.4 } }
  texture { pigment { rgbt <1, 1, 1, 0.7> } normal { wrinkles 0.5 scale 0.3 } finish { reflection 0.2 specular 0.6 } }
}
