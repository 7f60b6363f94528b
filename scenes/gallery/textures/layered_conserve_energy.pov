// conserve_energy, mirrors in two layers, what shines through.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
plane { y, -1.5 pigment { checker rgb 0.9, rgb 0.3 } }
plane { -z, -4 pigment { gradient y color_map { [0.5 rgb <1, 0.8, 0.6>] [0.5 rgb 0.3] } } }
sphere { 0, 0.95 texture { pigment { rgb <1, 0.5, 0.2> } finish { reflection 0.3 } } texture { pigment { rgbt <1, 1, 1, 0.7> } finish { reflection 0.5 conserve_energy } } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 texture { pigment { rgb <0.2, 0.5, 1> } } texture { pigment { rgbf <1, 1, 1, 0.8> } finish { reflection { 0, 0.9 fresnel } conserve_energy } } interior { ior 1.5 } translate <0, 1.15, 0> }
sphere { 0, 0.95 texture { pigment { rgbf 0.9 } finish { reflection 0.2 conserve_energy } } translate <2.3, 1.15, 0> }
