// orient turns the disc to each point; its diameter is the first axis alone.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end

light_source { <1.5, 1.6, -2> rgb 0.7 area_light <1.2, 0, 0>, <0, 0, 0.2>, 5, 5 circular orient }
light_source { <-2, 3, -2> rgb 0.4 area_light <1, 0, 0>, <0, 1, 0>, 4, 4 orient adaptive 1 }
