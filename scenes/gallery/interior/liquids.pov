// Water in glasses of which it shares the inner faces: leaning cylinders, cones, a turned bowl, boxes.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0.3, 2.8, -8> look_at <0, 0.5, 0> angle 42 }
light_source { <5, 10, -8>, 1 }
light_source { <-8, 6, -3>, 0.5 }
background { rgb <0.4, 0.6, 0.8> }
plane { y, 0 pigment { checker rgb 1, rgb 0.2 } }
#declare Glass = material {
  texture { pigment { rgbt <0.95, 1, 0.95, 0.9> } finish { specular 0.5 reflection 0.1 } }
  interior { ior 1.5 }
}
#declare Water = material {
  texture {
    pigment { rgbt <0.9, 0.95, 1, 0.95> }
    finish { specular 0.3 reflection { 0.05, 0.5 fresnel } conserve_energy }
  }
  interior { ior 1.33 }
}
union {
  difference { cylinder { 0, 1.5 * y, 0.6 } cylinder { 0.1 * y, 1.6 * y, 0.5 } material { Glass } }
  cylinder { 0.1 * y, 0.9 * y, 0.5 material { Water } }
  rotate 20 * z
  translate <-1.7, 0.3, 0>
}
difference {
  cone { 0, 0.4, 1.5 * y, 0.7 }
  cone { 0.1 * y, 0.3, 1.501 * y, 0.6 }
  material { Glass }
}
cone { 0.1 * y, 0.3, 0.8 * y, 0.45 material { Water } }
union {
  difference { sphere { 0, 0.7 } sphere { 0, 0.6 } plane { -y, -0.3 } material { Glass } }
  intersection { sphere { 0, 0.6 } plane { y, 0 } material { Water } }
  translate <1.6, 0.75, 0>
}
union {
  box { <-0.5, 0, -0.5>, <0.5, 0.5, 0.5> material { Glass } }
  box { <-0.5, 0, -0.5>, <0.5, 0.2, 0.5> material { Water } }
  rotate 25 * y
  translate <-0.5, 0, -2>
}
prism {
  cubic_spline 0, 0.5, 8
  <-1, 0>, <0, -1>, <1, 0>, <0.5, 0.6>, <0, 1>, <-1, 0.3>, <0, -1>, <1, 0>
  material { Glass }
  scale 0.7
  translate <1, 0, -2>
}
