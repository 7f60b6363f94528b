// projected_through in an area light: each point of the grid shines through by itself. A shadowless
// light is projected, too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end

light_source {
  <1, 4, -3> rgb 0.8
  area_light <0.8, 0, 0>, <0, 0, 0.8>, 5, 5
  projected_through { box { <0, 2, -2>, <1, 2.1, -1> } }
}
light_source {
  <-3, 3, -2> rgb <0.3, 0.2, 0> shadowless
  projected_through { sphere { <-2, 2, -1.5>, 0.5 } }
}
