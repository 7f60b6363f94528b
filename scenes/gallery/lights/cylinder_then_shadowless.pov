// The last kind of light wins, but what was a cylinder stays parallel.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at <0, 0, 0> angle 45 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.5 } }
sphere { <-1.5, 0, 0>, 1 pigment { rgb <1, 0.8, 0.6> } finish { phong 0.5 } }
cylinder { <1.5, -1, 0>, <1.5, 1, 0>, 0.7 pigment { rgb <0.6, 0.8, 1> } }
light_source { <-2, 3, -2> rgb <0.7, 0.6, 0.3>
  cylinder radius 0.4 falloff 0.9 point_at <0.5, -0.5, 0.5> shadowless
}
light_source { <3, 3, -1> rgb <0.3, 0.4, 0.7>
  cylinder radius 0.4 falloff 0.9 point_at <0, -0.5, 0> spotlight radius 20 falloff 30
}
