// Each sample of a parallel spotlight with area_illumination looks to point_at by itself: tightness and
// cone see its angle with the light's axis.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }
plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end
light_source {
  <-2, 3, -3> rgb 0.8 spotlight parallel point_at 0 tightness 15
  area_light 2*x, 2*z, 4, 4 area_illumination on
}
light_source {
  <2, 3, -3> rgb <0.2, 0.5, 0.3> spotlight parallel point_at 0 radius 4 falloff 9
  area_light 2*x, 2*z, 3, 3 area_illumination on
}
