// The inside of a surface has a look of its own, also for shadows that leave through it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
difference {
  sphere { <-1, 0.7, 0>, 0.7 } box { <-2, 0.7, -1>, <0, 2, 1> }
  texture { pigment { rgb <0.8, 0.7, 0.5> } } interior_texture { pigment { rgb <0.2, 0.8, 0.3> } finish { phong 1 } }
}
cylinder { <0.7, 0, 0>, <0.7, 1.2, 0>, 0.5 open texture { pigment { rgb <0.3, 0.4, 0.9> } } interior_texture { pigment { checker rgb 1 rgb <0.9, 0.2, 0.1> scale 0.2 } finish { reflection 0.3 } } }
sphere { <2, 0.4, -0.5>, 0.4 texture { pigment { rgbf <1, 0.6, 0.6, 0.9> } } interior_texture { pigment { rgbf <0.5, 1, 0.5, 0.8> } } }
