// Rays through smooth height fields and from discs have povray's last digits; they turn often, and the
// pigment behind shows what is below 1e-13.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0.1, 2.2, -9> look_at <0, 0.1, 0> angle 40 }
background { rgb <0.3, 0.4, 0.6> }
#declare Digits = texture {
  pigment { function { mod(x * pow(2, 46), 1) + 0.5 } }
  finish { ambient 1 diffuse 0 }
}
box { <-9, -9, 5>, <9, 9, 6> texture { Digits } }
#declare Hills = height_field {
  function 9, 7 { pattern { bumps scale 0.2 } }
  smooth
  translate <-0.5, -0.5, -0.5>
  texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }
  interior { ior 1.3 }
}
object { Hills scale <3, 1, 2> rotate -50 * x translate <-1.7, 1, 0> }
object { Hills scale <2.5, 0.8, 2> rotate <-40, 30, 10> translate <1.6, 1, 0> }
#declare Mirror = texture {
  pigment { rgb 0 }
  finish { ambient 0 diffuse 0 reflection 1 }
}
disc { <-1.5, -1.3, 1>, <0.232319, 0.460512, 0.92>, 0.9 texture { Mirror } }
disc { <1.5, -1.3, 1>, <-0.3, 0.7, -0.11>, 1.1, 0.3 texture { Digits } }
