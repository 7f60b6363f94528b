// Cylindrical lights: parallel rays inside a tube with a soft rim, nothing behind their plane.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end

light_source { <-1.6, 3, -2> rgb 1 cylinder point_at <-1.4, 0, 0> }
light_source { <0.4, 3, -2> rgb 1 cylinder point_at <0.2, 0, 0> radius 0.3 falloff 0.9 tightness 2 }
light_source { <2, 0.6, -1> rgb 0.7 cylinder point_at <1.4, 0.6, 0.5> radius 0.5 falloff 0.5 }
