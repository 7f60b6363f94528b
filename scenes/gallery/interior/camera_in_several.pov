// A camera inside several clear things: which of them a ray is in, and so where it is bent, follows the
// order of povray's hierarchy of boxes, not that of the declarations; what has no end comes first.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 1.5, -3> look_at <0, 1, 2> angle 70 }
plane { -z, -9 pigment { checker rgb 1 rgb 0.4 } finish { ambient 1 diffuse 0 } }
#macro Clear(Ior) hollow pigment { rgbf 0.98 } finish { ambient 0 diffuse 0 } interior { ior Ior } #end
sphere { <0.5, 1.5, -3.2>, 2 Clear(1.1) }
sphere { <-0.5, 1.2, -3>, 2.3 Clear(1.2) }
box { <-1.5, 0.2, -5>, <1.2, 3.4, -0.2> Clear(1.25) }
cylinder { <0.3, -1, -2.8>, <0.3, 4, -2.8>, 1.2 Clear(1.05) }
plane { z, 3 Clear(1.1) }
#declare I = 0;
#while (I < 12)
  sphere {
    <4 * cos(I), 1.5 + 3 * sin(I), 2 + mod(I, 4)>, 0.4
    pigment { rgb <I / 12, 0.5, 1 - I / 12> } finish { ambient 1 }
  }
  #declare I = I + 1;
#end
