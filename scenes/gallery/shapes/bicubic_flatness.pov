// bicubic_patch: flatness stops the subdivision early, and not the same everywhere; patches whose
// corners have run together.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -9> look_at 0 angle 46 }
light_source { <-5, 8, -10> rgb 1 }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { checker rgb <0.85, 0.8, 0.7> rgb <0.4, 0.5, 0.8> scale 0.3 } finish { phong 0.4 } }
#macro Patch(Flatness, U, V, A, B, C, D)
  bicubic_patch { type 1 flatness Flatness u_steps U v_steps V
    A, <-0.3, -0.9, 0.5>, <0.3, -0.8, 0>, B, <-0.9, -0.3, 0.4>, <-0.3, -0.3, -0.8>, <0.3, -0.3, 0.6>, <0.9, -0.3, 0>,
    <-0.9, 0.3, 0>, <-0.3, 0.3, 0.8>, <0.3, 0.3, -0.3>, <0.9, 0.3, 0.3>, C, <-0.3, 0.9, 0.1>, <0.3, 1, 0.5>, D }
#end
object { Patch(0.03, 4, 4, <-0.9, -0.9, 0>, <0.9, -0.9, 0>, <-0.9, 0.9, 0>, <0.9, 0.9, 0.2>) translate <-2.3, 1.15, 0> }
object { Patch(0.1, 3, 4, <-0.9, -0.9, 0>, <0.9, -0.9, 0>, <-0.9, 0.9, 0>, <0.9, 0.9, 0.2>) translate <0, 1.15, 0> }
object { Patch(0.2, 3, 2, <-0.9, -0.9, 0>, <0.9, -0.9, 0>, <-0.9, 0.9, 0>, <0.9, 0.9, 0.2>) translate <2.3, 1.15, 0> }
// The first row's ends are one; the first column's; the ends of a diagonal.
object { Patch(0.15, 3, 3, <0, -0.9, 0>, <0, -0.9, 0>, <-0.9, 0.9, 0>, <0.9, 0.9, 0.2>) translate <-2.3, -1.15, 0> }
object { Patch(0.15, 3, 3, <-0.9, 0, 0>, <0.9, -0.9, 0>, <-0.9, 0, 0>, <0.9, 0.9, 0.2>) translate <0, -1.15, 0> }
object { Patch(0.15, 3, 3, <-0.9, -0.9, 0>, <0, 0, -0.3>, <0, 0, -0.3>, <0.9, 0.9, 0.2>) translate <2.3, -1.15, 0> }
