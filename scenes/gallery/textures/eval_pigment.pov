// eval_pigment: colours looked up while the scene is read.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#include "functions.inc"
#declare P = pigment { marble turbulence 0.5 color_map { [0 rgb <1, 0.6, 0.2>] [0.5 rgb <0.2, 0.5, 0.8>] [1 rgb 1] } scale 0.7 }
sphere { 0, 0.95 pigment { rgb eval_pigment(P, <0.1, 0.2, 0.3>) } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 pigment { rgb eval_pigment(P, <0.5, 0.5, 0.3>) } translate <0, 1.15, 0> }
sphere { 0, 0.95 pigment { rgb eval_pigment(P, <1.2, -0.3, 0.3>) } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 pigment { rgb eval_pigment(P, <0.3, 3, 0.3>) } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 pigment { rgb eval_pigment(P, <-2, 0.7, 0.3>) } translate <0, -1.15, 0> }
sphere { 0, 0.95 pigment { rgb eval_pigment(P, <7, 7, 0.3>) } translate <2.3, -1.15, 0> }
