// Nested groups: lights come in from outside where all groups on the way have global_lights.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end

light_group {
  light_source { <-3, 3, -3> rgb <0.8, 0.1, 0.1> }
  sphere { <-1.5, 0.5, -1>, 0.4 pigment { rgb 1 } }
  light_group {
    light_source { <0, 3, -3> rgb <0.1, 0.8, 0.1> }
    sphere { <-0.5, 0.5, -1>, 0.4 pigment { rgb 1 } }
  }
  light_group {
    light_source { <0, 3, -3> rgb <0.1, 0.5, 0.5> }
    sphere { <0.5, 0.5, -1>, 0.4 pigment { rgb 1 } }
    global_lights on
  }
  global_lights off
}
light_group {
  light_group { sphere { <1.5, 0.5, -1>, 0.4 pigment { rgb 1 } } global_lights }
  global_lights
}
light_source { <3, 4, -3> rgb <0.2, 0.2, 0.9> }
