// Height fields: a function image, smooth and flat, with water_level, turned, sheared, uv mapped,
// cut by a cylinder and cutting a box.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 4, -6> look_at <0, 0, 0> angle 45 }
light_source { <-5, 8, -10>, 1 }
light_source { <6, 3, -4>, 0.4 shadowless }
background { rgb <0.1, 0.2, 0.3> }
#declare Hills = function { pattern { bozo scale 0.2 } }
#declare Field = height_field { function 24, 17 { Hills(x, y, z) } translate <-0.5, -0.5, -0.5> }
#declare Smooth = height_field { function 24, 17 { Hills(x, y, z) } smooth translate <-0.5, -0.5, -0.5> }
object { Field pigment { checker rgb 1, rgb <0.3, 0.5, 0.9> scale 0.2 } scale <2, 1, 2> translate <-2, 0.5, 0> }
object { Smooth pigment { rgb <0.9, 0.7, 0.3> } finish { phong 0.8 } scale <2, 1.5, 2> rotate <10, 20, 30> translate <0.3, 0.6, 0.3> }
height_field { function 30, 30 { Hills(y, x, z) } water_level 0.45
  uv_mapping pigment { checker rgb 1, rgb <0.8, 0.2, 0.2> scale 0.1 }
  matrix <2, 0.2, 0, 0, 1.5, 0, 0.5, 0, 2, 1.3, -0.5, -0.8> }
difference {
  object { Field pigment { rgb <0.4, 0.8, 0.4> } }
  cylinder { <0, -1, 0>, <0, 1, 0>, 0.3 pigment { rgb x } }
  scale 1.8 translate <-2, -0.8, -2>
}
difference {
  box { <-0.49, -0.6, -0.49>, <0.49, 0.3, 0.49> pigment { rgb <0.5, 0.5, 0.9> } }
  object { Smooth pigment { rgb <0.9, 0.9, 0.3> } }
  scale 1.5 translate <0, -0.7, -2.3>
}
intersection {
  box { <-0.4, -0.6, -0.4>, <0.4, 0.3, 0.4> }
  object { Field scale <1, 0.8, 1> }
  pigment { rgb <0.9, 0.5, 0.9> } scale 1.5 rotate -30*x translate <1.9, -0.7, -2.3>
}
