// area_illumination of cylinder and parallel lights: one cylinder about the centre, fading from each
// sample; orient turns the disc against the direction of the light, not towards its place.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -9> look_at <0, 0, 0.5> angle 45 }
plane { y, -1 pigment { checker rgb 0.9, rgb 0.6 } }
sphere { <-2, 0, 0>, 1 pigment { rgb <1, 0.8, 0.6> } finish { phong 0.5 } }
box { <1, -1, -1>, <3, 0.3, 1> pigment { rgb <0.6, 0.8, 1> } rotate 20*y }
light_source { <-3, 5, -2> rgb <1, 0.9, 0.7>
  cylinder radius 1 falloff 2.2 point_at <-2, -1, 0.3> fade_distance 5 fade_power 2
  area_light 2*x, 1.5*z, 4, 3 area_illumination on
}
light_source { <4.4, 5.3, 1.4> rgb 0.5
  parallel point_at <0.1, 0.4, -0.4> fade_distance 4 fade_power 2
  area_light <-1.6, -0.7, -0.6>, <0.9, 0.5, -1.6>, 4, 3 circular orient area_illumination on
}
