// bump_size: in the statement, in a copy, negative.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.6, -9> look_at <0, 0, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
light_source { <6, 3, -8> rgb 0.3 shadowless }
background { rgb <0.15, 0.2, 0.3> }
#default { pigment { rgb <0.85, 0.8, 0.7> } finish { phong 0.4 phong_size 30 } }
#declare Base = normal { bozo 0.7 accuracy 0.05 scale 0.3 }
sphere { 0, 0.95 normal { gradient x triangle_wave bump_size 1 scale 0.3 } translate <-2.3, 1.15, 0> }
sphere { 0, 0.95 normal { Base } translate <0, 1.15, 0> }
sphere { 0, 0.95 normal { Base bump_size 2 } translate <2.3, 1.15, 0> }
sphere { 0, 0.95 normal { Base bump_size -1 } translate <-2.3, -1.15, 0> }
sphere { 0, 0.95 normal { Base scale 0.5 turbulence 0.3 } translate <0, -1.15, 0> }
sphere { 0, 0.95 normal { Base granite 0.3 } translate <2.3, -1.15, 0> }
