// A light in a union is a global one even inside a group; a light in a difference inside a group is, too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end

light_group {
  light_source { <-3, 3, -3> rgb <0.6, 0.1, 0.1> }
  union {
    sphere { <-0.5, 0.5, -1>, 0.4 pigment { rgb 1 } }
    light_source { <3, 3, -3> rgb <0.1, 0.1, 0.6> }
  }
  difference {
    sphere { <0.7, 0.5, -1>, 0.45 } sphere { <0.7, 0.7, -1.3>, 0.3 }
    pigment { rgb 1 }
  }
}
