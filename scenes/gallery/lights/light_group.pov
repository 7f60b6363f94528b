// A group: its lights shine on its members only, which do not see the global light, but all
// objects cast shadows in all lights.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end

light_group {
  light_source { <-3, 3, -2> rgb <1, 0.3, 0.2> }
  sphere { <-0.5, 0.5, -1>, 0.4 pigment { rgb 1 } }
  union { box { <0.4, 0, -1.4>, <1, 0.5, -0.9> } sphere { <0.7, 0.7, -1.1>, 0.25 } pigment { rgb 0.9 } }
}
light_source { <3, 4, -3> rgb 0.8 }
