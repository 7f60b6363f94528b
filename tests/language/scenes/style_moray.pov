// exported modeller file, in the manner of modellers of the nineties
#version 3.0
global_settings {
  adc_bailout          0.003922
  ambient_light        <1.0,1.0,1.0>
  assumed_gamma        1.9
  hf_gray_16           off
  irid_wavelength      <0.247059,0.176471,0.137255>
  max_intersections    64
  max_trace_level      10
  number_of_waves      10
}
background { color <0.000,0.000,0.350> }
camera {
  location  <  0.000,  -10.000,    2.000>
  sky       <    0.00000,    0.00000,    1.00000> // Use right handed-system
  up        <        0.0,        0.0,        1.0> // Where Z is up
  right     <    1.33333,        0.0,        0.0> // Aspect ratio
  direction <        0.0,        1.5,        0.0>
  look_at   <   0.000,      0.000,      0.000>
}
#declare Red_Glossy =
   material
   {
      texture
      {
         pigment { color rgb <0.9, 0.1, 0.1> }
         finish { ambient 0.2 diffuse 0.7 phong 0.6 phong_size 60.0 }
      }
      interior { ior 1.3 }
   }
#declare Old_Stone = texture {
   pigment { granite turbulence 0.5
      color_map { [0.0, 0.3 color red 0.8 green 0.7 blue 0.6 color red 0.5 green 0.4 blue 0.3]
                  [0.3, 1.001 color red 0.5 green 0.4 blue 0.3 color red 0.9 green 0.9 blue 0.9] } }
   finish { crand 0.0 ambient 0.15 }
}
light_source {   // Light001
  <5.000, -8.000, 10.000>
  color red 1.000 green 1.000 blue 1.000
  spotlight
    point_at  <0.0, 0.0, 0.0>
    tightness 10.0
    radius 30.0
    falloff 45.0
}
light_source { <-5, -10, 5> color rgb <0.4, 0.4, 0.5> fade_distance 10 fade_power 1 }
object {  // Sphere001
   sphere { <0,0,0>,1 }
   texture { pigment { color rgb <0.9, 0.1, 0.1> } finish { phong 0.6 } }
   scale <1.0, 1.2, 0.8>
   rotate <0.0, 20.0, -30.0>
   translate  <-1.500000,0.0,0.5>
}
union { // Group
  box { <-1, -1, -1>, <1, 1, 1> scale <0.5, 0.5, 0.5> }
  cylinder { <0,0,1>, <0,0,0>, 1 open scale <0.3, 0.3, 1.5> translate 0.5*z }
  cone { <0,0,0>, 0.0, <0,0,1>, 1.0 translate z*2 scale 0.5 }
  torus { 1.0, 0.25 rotate -x*90 }
  texture { Old_Stone scale 0.5 }
  translate <1.5, 0, 0>
}
plane { z,0 texture { pigment { checker color red 1 color blue 1 green 1 } finish { reflection 0.2 } } translate -z }
