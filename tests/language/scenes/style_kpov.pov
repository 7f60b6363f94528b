/*
KPovModeler style
*/
#declare global_unit = 1;

camera { perspective
  location <0.0, 1.0, -5.0>
  sky <0.0, 1.0, 0.0>
  direction <0.0, 0.0, 1.0>
  right <1.33333, 0.0, 0.0>
  up <0.0, 1.0, 0.0>
  look_at <0.0, 0.0, 0.0>
}

light_source { <4.0, 5.0, -5.0>
  rgb <1.0, 1.0, 1.0>
}

#declare Marble1 = pigment { marble
  turbulence <0.6, 0.6, 0.6>
  color_map {
    [ 0.0 rgbft <0.9, 0.9, 0.85, 0.0, 0.0> ]
    [ 1.0 rgbft <0.3, 0.2, 0.2, 0.0, 0.0> ]
  }
}
difference {
  box { <-1.0, -1.0, -1.0>, <1.0, 1.0, 1.0>
  }
  sphere { <0.0, 0.0, 0.0>, 1.25
  }
  texture {
    pigment { Marble1 }
    finish { ambient rgb <0.1, 0.1, 0.1> brilliance 1.0 specular 0.5 roughness 0.01 conserve_energy }
  }
  rotate <20.0, 35.0, 0.0>
}
lathe { quadratic_spline 5, <0.0, 0.0>, <0.5, 0.0>, <0.7, 0.5>, <0.3, 0.8>, <0.4, 1.2>
  texture { pigment { color rgb <0.2, 0.6, 0.3> } } translate <-2.0, -1.0, 1.0> }
object { sphere_sweep { cubic_spline 5 <-3.0,0,2> 0.2 <-2,1,2> 0.2 <0,1.5,2> 0.3 <2,1,2> 0.2 <3,0,2> 0.1 tolerance 0.001 }
  texture { pigment { rgb x } } }
text { ttf "cyrvetic.ttf" "kpm" 0.2, <0.05, 0.0, 0.0> texture { pigment { rgb y } } scale 0.7 translate <1.0, -1.0, -1.0> }
