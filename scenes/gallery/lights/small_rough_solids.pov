// Opaque things stop the light from 1e-4 on: in a scene of 0.05 across, their own bumps do.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.02, 0.03, -0.06> look_at <0, 0.002, 0> angle 45 }
background { rgb <0.2, 0.3, 0.5> }
light_source { <0.06, 0.01, -0.02>, rgb 1.3 }
plane { y, -0.008 pigment { checker rgb 1, rgb 0.5 scale 0.01 } }
#default { texture { pigment { rgb <0.8, 0.9, 0.5> } } }
height_field {
  function 14, 14 { pattern { bumps scale 0.13 } }
  translate <-0.5, -0.5, -0.5>
  scale <0.04, 0.012, 0.03>
  translate 0.008 * z
}
blob {
  threshold 0.3
  sphere { <-0.3, 0, 0>, 0.5, 1 }
  sphere { <0.3, 0.1, 0>, 0.6, 1 }
  sphere { <0, 0.3, -0.3>, 0.4, 1 }
  scale 0.012
  translate <-0.012, 0, -0.018>
}
mesh {
  #declare I = 0;
  #while (I < 12)
    triangle {
      <cos(I), 0.1 * I, sin(I)>, <cos(I + 2), 0.1 * I + 0.3, sin(I + 2)>, <cos(I + 4), 1, sin(I + 4)>
    }
    #declare I = I + 1;
  #end
  scale 0.006
  translate <0.012, -0.005, -0.016>
}
