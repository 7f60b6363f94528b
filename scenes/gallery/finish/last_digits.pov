// With 16 bits of depth: shares of light that are rounded once, in POV-Ray's order.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> look_at 0 }
light_source { <6, 0, -10> rgb <0.7, 0.3, 0.9> fade_distance 9 fade_power 1.5 }
light_source { <-6, 3, -10> rgb <0.37, 0.61, 0.43> spotlight point_at 0 radius 9 falloff 25 tightness 2 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.3, 0.5, 0.7>] [1 rgb <0.9, 0.4, 0.2>] } } }
plane {
  z, 1
  texture { pigment { rgb <0.6, 0.4, 0.2> } finish { diffuse 0.7 brilliance 1.7 } }
  texture { pigment { rgbt <0.3, 0.2, 0.1, 0.5> } finish { diffuse 0.4 phong 0.3 } }
}
sphere { <-1.6, 0, 0>, 0.7 pigment { rgb <0.6, 0.4, 0.2> } finish { diffuse 0.7 phong 0.7 specular 0.4 } }
sphere { 0, 0.7 pigment { rgb <0.6, 0.4, 0.2> } finish { reflection { 0.13, 0.87 falloff 2.3 } conserve_energy } }
sphere {
  <1.6, 0, 0>, 0.7
  texture {
    gradient y
    texture_map {
      [0 pigment { rgb <0.6, 0.4, 0.2> } finish { diffuse 0.7 }]
      [1 pigment { rgb <0.2, 0.7, 0.9> } finish { diffuse 0.3 irid { 0.4 thickness 0.5 } }]
    }
  }
}
