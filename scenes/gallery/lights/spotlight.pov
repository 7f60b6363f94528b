// Spotlights: the cubic edge between radius and falloff, a hard edge where they agree, and one
// whose radius is greater than its falloff.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end

light_source { <-1.5, 4, -2> rgb <1, 0.3, 0.3> spotlight point_at <-1.5, 0, 0> radius 8 falloff 16 }
light_source { <0, 4, -2> rgb <0.3, 1, 0.3> spotlight point_at <0, 0, 0> radius 11 falloff 11 }
light_source { <1.5, 4, -2> rgb <0.3, 0.3, 1> spotlight point_at <1.5, 0, 0> radius 14 falloff 9 }
