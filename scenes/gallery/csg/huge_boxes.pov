// Boxes of more than 2e10 volume count as infinite, and cut what is seen all the same; those of solids move
// with them.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1e6, 3.5e5, -6e5> look_at <1e6, 0, 0> angle 50 }
background { rgb <0.2, 0.3, 0.5> }
light_source { <1.4e6, 8e5, -6e5>, rgb 1 }
plane { y, -1.3e5 pigment { checker rgb 1 rgb 0.5 scale 5e4 } }
#default { texture { pigment { rgb <1, 0.6, 0.2> } finish { specular 0.4 } } }
union {
  intersection { disc { 0, <-0.85, 0.48, -0.71>, 0.7 } box { -0.8, 0.8 } translate <-1.8, 0.2, 0> }
  intersection { disc { 0, z, 0.6, 0.2 } torus { 0.6, 0.3 rotate 50 * x } translate <0, -0.3, -1> }
  scale 1e5
  translate 1e6 * x
}
blob {
  threshold 0.3
  sphere { -0.3 * x, 1, 1 }
  sphere { 0.4 * x, 0.8, 1 }
  bounded_by { box { -0.45, 0.5 } }
  translate <0, 0.3, 1>
  scale 1e5
  translate 1e6 * x
}
difference {
  superellipsoid { <0.3, 0.3> }
  cylinder { -2 * z, 2 * z, 0.5 }
  rotate 30 * y
  scale 6e4
  translate <1.17e6, 0, 0>
}
