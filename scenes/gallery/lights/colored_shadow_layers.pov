// Shadows of layered and patterned panes: all layers filter; a layer that lets nothing through makes
// the whole opaque.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }

box {
  <-2, 0, -0.05>, <-0.8, 1.2, 0.05>
  texture { pigment { checker rgbf <1, 0.3, 0.3, 0.9> rgbt 1 scale 0.3 } }
  texture { pigment { rgbf <0.6, 0.8, 1, 0.8> } }
}
box {
  <-0.6, 0, -0.05>, <0.6, 1.2, 0.05>
  texture { gradient x texture_map { [0.3 pigment { rgb 0.2 }] [0.7 pigment { rgbf <0.2, 1, 0.5, 0.9> }] } translate 0.5*x }
}
box {
  <0.8, 0, -0.05>, <2, 1.2, 0.05>
  texture { pigment { rgb <0.4, 0.3, 0.6> } }
  texture { pigment { rgbt 1 } }
}
light_source { <0.5, 3, 4> rgb 1 }
light_source { <0, 5, -5> rgb 0.3 shadowless }
