// Cylinders along z, of lengths whose reciprocal is rounded, and boxes that end in the planes of their discs.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.3, 0.4, -7> look_at 0 angle 42 }
background { rgb 0.1 }
#default { finish { ambient 1 diffuse 0 } }
#declare I = 0;
#while (I < 12)
  #declare Depth = 0.1 + 0.07 * I;
  #declare Where = <mod(I, 4) * 1.3 - 2, int(I / 4) * 1.4 - 1.4, 0>;
  cylinder { Where + 0.1 * z, Where + (0.1 + Depth) * z, 0.6 pigment { rgb <1, I / 12, 0> } }
  box { Where + <-0.3, -0.5, 0.1>, Where + <0.4, 0.3, 0.1 + Depth> pigment { rgb <0, I / 12, 1> } }
  cone { Where + <0, 0.1, 0.1>, 0.3, Where + <0, 0.1, 0.1 + Depth>, 0.2 pigment { rgb <0, 1, I / 12> } }
  #declare I = I + 1;
#end
