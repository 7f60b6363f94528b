// Lights turn and grow as objects do: location, point_at and axes, in a union, in a copy, and in a
// copy that is changed further.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
#for (I, -2, 2)
  cylinder { <I, 0, 0>, <I, 0.9, 0>, 0.2 pigment { rgb <0.5 + 0.2*I, 0.6, 0.7 - 0.2*I> } }
#end

#declare Lamp = light_source { <0, 3, 0> rgb 0.4 spotlight point_at <0.4, 0, 0> radius 10 falloff 20 area_light 0.5*x, 0.5*z, 3, 3 }
light_source { Lamp rotate 20*z translate <-1, 0.3, -0.6> }
object { Lamp scale <1, 1.4, 1> translate <0, 0, -0.8> }
union {
  light_source { Lamp }
  sphere { <0, 0.3, 0>, 0.3 pigment { rgb <0.8, 0.6, 0.2> } }
  rotate 10*z translate <1.2, 0, -0.8>
}
