#version 3.7;
// Values above white are averaged unclipped; negative colours count as black in contrasts.
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y }
#default { finish { ambient 0 diffuse 0 emission 1 } }
background { rgb <0.2, 0.3, 0.4> }
box { <-1.6, -0.2, 0>, <1.6, 0.1, 1> rotate z*11 translate 0.7*y pigment { rgb <8, 3, 0.5> } }
box { <-1.6, -0.2, 0>, <1.6, 0.1, 1> rotate z*-7 translate -0.6*y pigment { rgb <-2, 0.3, -0.1> } }
sphere { <0.3, 0.1, 0>, 0.3 pigment { rgb <0.25, 0.3, 0.4> } }
