// Light domes: each of 900 lights adds next to nothing to a dark surface, and less to its reflection.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -9> look_at 0 angle 40 }
#declare Place = seed(4);
#for (I, 1, 900)
  light_source { <rand(Place) * 18 - 9, 3 + 6 * rand(Place), -9 * rand(Place)>, rgb 0.0009 shadowless }
#end
light_source { <5, 8, -9>, rgb <0.02, 0.01, 0.03> }
plane { y, -1 pigment { rgb 0.9 } finish { ambient 0 diffuse 0.05 } }
sphere { <-1.2, 0, 0>, 1 pigment { rgb 0.9 } finish { ambient 0 diffuse 0.03 } }
sphere { <1.2, 0, 0>, 1 pigment { rgb 0.9 } finish { ambient 0 diffuse 0.02 reflection 0.3 } }
