// Behind the plane of a parallel light the distance is negative: such points are lit and see no
// shadows, and not every power of the distance exists there.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end

light_source { <0.2, 0.5, 0> rgb 0.7 parallel point_at <1.2, 0, 0.4> }
light_source { <-0.2, 0.5, 0> rgb <0.6, 0.2, 0.1> parallel point_at <-1.2, 0.2, 0.4> fade_distance 2 fade_power 1.5 }
// With spotlight, behind the plane is behind the cone.
light_source { <1.5, 1, 1> rgb <0.1, 0.5, 0.3> spotlight parallel point_at <3, 0, -1> }
