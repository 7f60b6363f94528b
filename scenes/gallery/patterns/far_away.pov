// Patterns of noise far from their origin: where coordinates leave 2^31, the noise is 0 or 1. No sample lies on an
// edge or at 0: there the noise of a pattern of 1e-9 is that of the last bit.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { orthographic location -10*z right 4*x up 3*y look_at 0 }
#default { finish { ambient 1 diffuse 0 } }
#macro Strip(P, Y)
  box { 0, <4, 0.4, 1> pigment { P color_map { [0 rgb <0.2, 0.1, 0.4>] [0.5 rgb <0.9, 0.7, 0.2>] [1 rgb <0.3, 1, 1>] }
    warp { planar } scale 1e-9 translate <0.3017, 0.2013, 0> } translate <-2, Y + 0.0037, 0> }
#end
Strip(pigment { bozo }, -1.4)
Strip(pigment { bozo turbulence 1.5 octaves 10 lambda 2.5 }, -0.9)
Strip(pigment { wrinkles }, -0.4)
Strip(pigment { granite }, 0.1)
Strip(pigment { marble turbulence 0.5 }, 0.6)
Strip(pigment { bumps noise_generator 1 }, 1.1)
