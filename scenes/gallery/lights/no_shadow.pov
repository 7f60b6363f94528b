// no_shadow: of one ball, of a union as a whole, and of all members of a union.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }

sphere { <-1.5, 0.5, -0.5>, 0.4 pigment { rgb <0.9, 0.5, 0.3> } no_shadow }
union { sphere { <0, 0.3, -0.5>, 0.3 } box { <-0.2, 0.6, -0.7>, <0.2, 0.9, -0.3> } pigment { rgb <0.4, 0.9, 0.3> } no_shadow }
union {
  sphere { <1.2, 0.3, -0.5>, 0.3 no_shadow } box { <1.4, 0.6, -0.7>, <1.8, 0.9, -0.3> no_shadow }
  pigment { rgb <0.3, 0.4, 0.9> }
}
cylinder { <-2, 0, 0.6>, <-2, 1, 0.6>, 0.2 pigment { rgb 0.7 } }
light_source { <3, 4, -3> rgb 1 }
