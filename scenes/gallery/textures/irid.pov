// irid: amount, thickness, turbulence; many layers of colour.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
global_settings { irid_wavelength rgb <0.7, 0.5, 0.4> }
sphere { 0, 0.95 pigment { rgb 0.3 } finish { irid { 0.35 thickness 0.5 } } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 pigment { rgb 0.3 } finish { irid { 0.6 thickness 1 turbulence 0.5 } specular 0.5 } translate <0, 1.15, 0> }
sphere { 0, 0.95 pigment { rgb <0.5, 0.4, 0.2> } finish { irid { 1 thickness 0.2 turbulence 2 } } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 pigment { rgb 0.2 } normal { bumps 0.4 scale 0.3 } finish { irid { 0.5 thickness 0.7 } reflection 0.2 } translate <-2.3, -1.15, 0> }
