// Object patterns that move their object in place, in pigments, normals, textures and functions.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -5> look_at 0 }
light_source { <-5, 8, -10> rgb 1 }
#declare Ball = sphere { 0, 1 }
#declare In = function { pattern { object { Ball scale .4 translate -.2*y } } }
plane {
  z, 1
  pigment { object { Ball scale 0.5 translate <.3, 1, 1> rgb <1, .3, .2>, rgb .7 } }
}
sphere {
  <-1.2, -.8, 0>, .8
  texture {
    object {
      box { -1, 1 } rotate 45*z scale <.5, .9, 1> translate <-1.2, -.8, 0>
      texture { pigment { rgb <.2, .5, 1> } finish { phong .8 } }
      texture { pigment { rgb <1, .9, .3> } }
    }
  }
}
sphere {
  <1.2, -.8, 0>, .8
  pigment { rgb .9 }
  normal {
    object {
      object { Ball } matrix <.5, .2, 0, 0, .5, 0, 0, 0, 1, 1.2, -.8, 0>
      normal { bumps 1 scale .1 } normal { wrinkles .5 scale .3 }
    }
  }
}
box { <-.5, .9, -.5>, <.5, 1.5, 0> pigment { function { In(3*x, 3*y - 3.6, z) } } }
