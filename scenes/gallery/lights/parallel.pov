// Parallel rays: shadows of the same shape everywhere, also with an area light, which then softens
// them by its own directions.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end

light_source { <30, 40, -30> rgb 0.5 parallel point_at <0, 0, 0> }
light_source { <-3, 4, -3> rgb 0.5 parallel point_at <0, 0, 0> area_light <0.8, 0, 0>, <0, 0, 0.8>, 4, 4 }
