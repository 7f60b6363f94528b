// A sheet of cameras: frame n of 13 (+KFF13) looks at one scene through the n-th kind of camera.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Kind = max(1, frame_number);
camera {
  #switch (Kind)
    #case (1) perspective #break
    #case (2) orthographic #break
    #case (3) fisheye angle 160 #break
    #case (4) ultra_wide_angle angle 120 #break
    #case (5) omnimax angle 150 #break
    #case (6) panoramic angle 140 #break
    #case (7) spherical angle 300 120 #break
    #case (8) cylinder 1 angle 120 #break
    #case (9) cylinder 2 angle 90 #break
    #case (10) cylinder 3 angle 120 #break
    #case (11) cylinder 4 angle 90 #break
    #case (12) perspective aperture 0.3 blur_samples 12 focal_point <0, 1, 0> #break
    #else perspective angle 40 normal { ripples 0.1 scale 0.2 }
  #end
  location <0, 3, -6>
  look_at <0, 1, 0>
}
light_source { <6, 9, -8> rgb 0.9 }
light_source { <-8, 5, -2> rgb 0.3 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.7, 0.8, 1>] [1 rgb <0.2, 0.3, 0.6>] } } }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.2, 0.3, 0.25> } finish { reflection 0.1 } }
#for (I, 0, 35)
  sphere {
    <3 + mod(I, 3), 0.5 + mod(I, 4) * 0.6, 0>, 0.3
    rotate I * 10 * y
    pigment { rgb <0.4 + 0.5 * mod(I, 2), 0.5, 0.9 - 0.02 * I> }
    finish { specular 0.5 reflection 0.2 }
  }
#end
difference {
  box { <-1, 0, -1>, <1, 2, 1> }
  sphere { <0, 1, 0>, 1.2 }
  pigment { rgb <0.8, 0.6, 0.3> }
}
