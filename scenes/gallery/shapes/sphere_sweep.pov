// Sphere sweeps: linear, cubic and b-splines, in CSG, moved, uv mapped, one sphere within another.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -9> look_at 0 angle 50 }
light_source { <-5, 8, -10>, 1 }
light_source { <6, -3, -8>, 0.4 shadowless }
background { rgb <0.1, 0.2, 0.3> }
#default { pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.5 } }
#declare Random = seed(3);
#macro Points(N)
  #local I = 0;
  #while (I < N)
    , <rand(Random), rand(Random), rand(Random)>*2 - <1, 1, 1>, 0.1 + 0.2*rand(Random)
    #local I = I + 1;
  #end
#end
sphere_sweep { linear_spline 7 Points(7) translate <-3, 1.6, 0> }
sphere_sweep { b_spline 12 Points(12) pigment { rgb <0.4, 0.8, 0.4> } translate <0, 1.6, 0> }
sphere_sweep { cubic_spline 9 Points(9) tolerance 0.01 uv_mapping pigment { checker rgb 1, rgb <0.8, 0.2, 0.2> scale 0.2 }
  translate <3, 1.6, 0> }
difference {
  sphere_sweep { cubic_spline 9 Points(9) scale 1.4 }
  box { <-2, -2, -2>, <2, 2, -0.1> pigment { rgb <0.4, 0.5, 0.9> } }
  rotate 20*y translate <-3, -1.4, 0>
}
difference {
  box { -1, 1 pigment { rgb <0.9, 0.9, 0.5> } }
  sphere_sweep { b_spline 9 Points(9) scale <1.5, 1.5, 2> }
  rotate <-20, 30, 0> translate <0, -1.4, 0>
}
sphere_sweep { linear_spline 2, <0, 0, 0>, 0.5, <0.1, 0, 0>, 1 pigment { rgbt <0.5, 0.7, 0.9, 0.5> }
  matrix <1, 0.3, 0, 0, 1, 0, 0, 0.2, 1, 3, -1.4, 0> }
