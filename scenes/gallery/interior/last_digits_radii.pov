// The last digits of what is seen through spheres whose radius has a rounded reciprocal, and through turned planes
// and discs.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
camera { location <0, 0, -7> look_at 0 angle 50 }
plane {
  z, 1.5
  pigment { function { mod(abs(x) * pow(2, 44) + abs(y) * pow(2, 44) * 1.37, 1) } }
  finish { ambient 1 diffuse 0 }
}
#macro Glass() pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 1.4 } #end
sphere { <-1.9, 1.1, -1>, 1.1 Glass() }
sphere { <0.5, 1.2, -0.5>, 1.3 Glass() }
sphere { <2.2, -0.2, 0.5>, 0.7 Glass() }
intersection {
  plane { -z, 1.5 rotate 13 * y scale 1.3 }
  plane { <0.1, 0.2, 1>, -0.05 rotate 7 * y }
  cylinder { -4 * z, 4 * z, 1.2 }
  Glass()
  translate <-1.2, -1.3, 0>
}
disc { <2, -1.9, 0>, <0.1, 0.2, -1>, 1 Glass() }
disc { <1, -1.7, 0>, <0.1, 0.2, -1>, 0.9, 0.3 rotate 5 * y scale <1, 1.1, 1> Glass() }
