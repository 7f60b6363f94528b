// The keyword spotlight sets radius, falloff and tightness back to 30, 45 and 0: only what follows
// it counts. point_at is <0, 0, 1> if it is not given.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end

light_source {
  <0, 3, -3> rgb 0.8
  spotlight radius 5 falloff 8 tightness 40
  spotlight point_at <0.5, 0, 0> falloff 34
}
light_source { <-1.5, 2, -2.5> rgb <0.6, 0.3, 0.1> spotlight radius 20 falloff 30 }
