// The faint rim of a highlight on glass that scatters nothing: it decides codes amid two.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -3> look_at 0 }
light_source { <0, 0, -90> rgb 1 }
light_source { <-31, 11, -90> rgb <0.5, 0.7, 1> }
sphere {
  0, 1
  pigment { rgbf <1, 1, 1, 0.7> }
  finish { ambient 0 diffuse 0 specular 0.3 roughness 0.01 }
}
