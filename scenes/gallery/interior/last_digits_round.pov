// Tori and surfaces of revolution of glass, turned, sheared, and where they lie in one another: the
// pigment behind shows what is below 1e-9 of the points that rays meet.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0.1, 0.2, -9> look_at <0, 0.1, 0> angle 40 }
background { rgb <0.3, 0.4, 0.6> }
plane {
  <0, 0, -3>, -2
  pigment { function { mod(x * pow(2, 30), 1) + 0.5 } }
  finish { ambient 1 diffuse 0 }
  scale <1, 1.1, 0.9>
  translate 3 * z
}
#declare Glass = material {
  texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
  interior { ior 1.5 }
}
torus { 0.5, 0.2 rotate <-60, 0, 20> material { Glass } translate <-2.3, 1.2, 0> }
torus {
  0.5, 0.2 sturm
  matrix <1, 0.2, 0, -0.1, 0.9, 0.3, 0.2, -0.4, 1, 0, 0, 0>
  material { Glass }
  translate <-0.7, 1.2, 0>
}
union {
  torus { 0.5, 0.2 pigment { rgbt <1, 0.4, 0.4, 0.9> } }
  torus { 0.5, 0.2 pigment { rgbt <0.4, 0.4, 1, 0.9> } }
  finish { ambient 0 diffuse 0 }
  interior { ior 1.3 }
  rotate <-50, 0, 10>
  translate <0.8, 1.2, 0>
}
difference {
  torus { 0.5, 0.25 pigment { rgbt 1 } }
  torus { 0.5, 0.15 pigment { rgbt 1 } }
  finish { ambient 0 diffuse 0 }
  interior { ior 1.4 }
  rotate <-40, 0, 0>
  translate <2.3, 1.2, 0>
}
#declare Points = array[7] {
  <0, -0.7>, <0.45, -0.6>, <0.5, -0.4>, <0.25, 0>, <0.3, 0.3>, <0.4, 0.6>, <0.45, 0.8>
}
#macro Seven() Points[0], Points[1], Points[2], Points[3], Points[4], Points[5], Points[6] #end
sor { 7, Seven() rotate <20, 0, 10> material { Glass } translate <-2.2, -1, 0> }
sor { 7, Seven() open rotate <-20, 0, 10> material { Glass } translate <-0.8, -1, 0> }
sor { 7, Seven() sturm rotate <-20, 0, 0> material { Glass } translate <0.7, -1, 0> }
difference {
  sor { 7, Seven() pigment { rgbt 1 } }
  sor { 7, Seven() pigment { rgbt 1 } scale <0.9, 1, 0.9> translate 0.1 * y }
  finish { ambient 0 diffuse 0 }
  interior { ior 1.4 }
  rotate <-20, 0, 0>
  translate <2.2, -1, 0>
}
