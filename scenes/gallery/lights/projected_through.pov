// Light only through a window: what stands between the window and the light casts no shadow.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end

light_source {
  <1, 4, -3> rgb 1
  projected_through { box { <0, 2, -2>, <1, 2.4, -1.8> } }
}
sphere { <0.8, 3.4, -2.6>, 0.15 pigment { rgb <0.9, 0.2, 0.2> } }
light_source { <0, 5, -5> rgb 0.2 shadowless }
