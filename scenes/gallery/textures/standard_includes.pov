// Textures of stones.inc, woods.inc, metals.inc, skies.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#include "colors.inc"
#include "stones.inc"
#include "woods.inc"
#include "metals.inc"
#include "skies.inc"
sphere { 0, 0.95 texture { T_Stone10 scale 0.5 } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 texture { T_Stone24 scale 0.5 } translate <0, 1.15, 0> }
sphere { 0, 0.95 texture { T_Wood7 scale 0.5 rotate 40*x } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 texture { T_Brass_3C } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 texture { pigment { P_Cloud2 scale 0.5 } } translate <0, -1.15, 0> }
sphere { 0, 0.95 texture { T_Grnt15 scale 0.5 } translate <2.3, -1.15, 0> }
