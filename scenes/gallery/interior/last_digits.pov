// Rays through glass have povray's last digits: the pigment behind shows what is below 1e-9. In air,
// within another interior, with dispersion; flat, round and turned faces, lathes of all splines.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0.1, 0.2, -9> look_at <0, 0.1, 0> angle 40 }
background { rgb <0.3, 0.4, 0.6> }
#declare Digits = texture {
  pigment { function { mod(x * pow(2, 30), 1) + 0.5 } }
  finish { ambient 1 diffuse 0 }
}
polygon { 5, <-9, -9, 5>, <9, -9, 5>, <9, 9, 5>, <-9, 9, 5>, <-9, -9, 5> texture { Digits } }
#declare Glass = material {
  texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
  interior { ior 1.5 }
}
#declare Spread = material {
  texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
  interior { ior 1.4 dispersion 1.05 dispersion_samples 3 }
}
box { -0.6, 0.6 rotate <20, 30, 0> material { Glass } translate <-2.3, 1.3, 0> }
sphere { 0, 0.7 material { Glass } translate <-0.8, 1.3, 0> }
cylinder { -0.6 * y, 0.6 * y, 0.5 rotate <30, 0, 20> material { Glass } translate <0.8, 1.3, 0> }
sphere { 0, 0.7 material { Spread } translate <2.3, 1.3, 0> }
sphere { <2.3, 1.3, 0>, 0.4 material { Glass } }
#declare Points = array[7] {
  <0.1, -0.8>, <0, -0.6>, <0.5, -0.5>, <0.2, 0>, <0.3, 0.3>, <0.4, 0.5>, <0.1, 0.7>
}
#macro Seven() Points[0], Points[1], Points[2], Points[3], Points[4], Points[5], Points[6] #end
lathe { linear_spline 7, Seven() material { Glass } rotate 20 * x translate <-2.1, -1, 0> }
lathe { quadratic_spline 7, Seven() material { Glass } rotate 20 * x translate <-0.7, -1, 0> }
lathe { cubic_spline 7, Seven() material { Glass } rotate 20 * x translate <0.7, -1, 0> }
lathe {
  bezier_spline 8, <0, -0.6>, <0.7, -0.6>, <0.6, -0.1>, <0.3, 0>, <0.3, 0>, <0.1, 0.1>, <0.6, 0.4>,
  <0, 0.5>
  material { Glass }
  translate <2.1, -1, 0>
}
