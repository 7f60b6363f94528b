// Fading: only fade_distance and fade_power together have an effect; a negative distance counts
// as it is. At the distance itself the light has its full strength, nearer it is brighter.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end

light_source { <-2, 1.5, -1> rgb <1, 0.6, 0.5> fade_distance 1.2 fade_power 2 }
light_source { <2, 1.5, -1> rgb <0.5, 0.6, 1> fade_distance 1.5 fade_power 3.5 }
light_source { <0, 4, -6> rgb 0.1 fade_power 2 }
light_source { <0, 4, -6> rgb 0.1 fade_distance 0.01 }
