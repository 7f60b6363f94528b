// Values at the ends of what normals accept: accuracy 0 and below, patterns along nothing, maps of one entry.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <3.0, 2.0, -20> look_at <3.0, 2.0, 0> up 4.5*y right 6*x }
light_source { <-30, 50, -60>, 1 }
background { rgb <0.2, 0.3, 0.5> }
#declare Place = <0 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { granite 0.5 accuracy 0 } translate Place }
#declare Place = <1 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { bozo normal_map { [0 granite 0.5 accuracy 0] [1 bumps 0.5] } scale 0.2 } translate Place }
#declare Place = <2 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { granite 0.5 accuracy -0.02 } translate Place }
#declare Place = <3 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { granite 0.5 accuracy 1e-300 } translate Place }
#declare Place = <4 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { granite 0 scale 0.3 } translate Place }
#declare Place = <5 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { bumps -1 scale 0.1 } translate Place }
#declare Place = <0 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { bumps 1e30 scale 0.2 } translate Place }
#declare Place = <1 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { granite 0.5 scale <0, 1, 1> } translate Place }
#declare Place = <2 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { facets coords 0 } translate Place }
#declare Place = <3 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { facets size 0 } translate Place }
#declare Place = <4 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { quilted 1 control0 -5 control1 1e10 scale 0.2 } translate Place }
#declare Place = <5 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { ripples 0.5 frequency 0 phase 0.2 } translate Place }
#declare Place = <0 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { waves 0.5 phase 1e20 scale 0.1 } translate Place }
#declare Place = <1 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { average normal_map { [0 bumps 1] [0 dents 1] } } translate Place }
#declare Place = <2 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { average normal_map { [1 bumps 1] [-1 dents 1] } scale 0.1 } translate Place }
#declare Place = <3 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { gradient x 1 slope_map { [0.5 <1, 1>] } } translate Place }
#declare Place = <4 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { gradient x 1 slope_map { [0.5 <1, 1>] [0.5 <0, -1>] } scale 0.3 } translate Place }
#declare Place = <5 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { gradient x 1 slope_map { [0.8 <1, 1>] [0.2 <0, -1>] } scale 0.3 } translate Place }
#declare Place = <0 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { crackle 1 metric 0 scale 0.2 } translate Place }
#declare Place = <1 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { gradient 0 1 } translate Place }
#declare Place = <2 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { function { sqrt(x) } 1 } translate Place }
#declare Place = <3 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { function { 1/x } 1 } translate Place }
#declare Place = <4 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { wrinkles 1 no_bump_scale scale 1e-3 } translate Place }
#declare Place = <5 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } normal { gradient x 0.5 poly_wave -1 scale 0.2 } translate Place }
