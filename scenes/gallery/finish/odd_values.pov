// Values at the ends of what finishes accept: zero and negative exponents, sizes and shares.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4.0, 2.0, -20> look_at <4.0, 2.0, 0> up 6*y right 8*x }
light_source { <-30, 50, -60>, 1 }
background { rgb <0.2, 0.3, 0.5> }
plane { -z, -1 pigment { checker rgb 0.3, rgb 0.6 scale 0.3 } }
#declare Place = <0 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { ambient -1 } translate Place }
#declare Place = <1 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { diffuse -1 } translate Place }
#declare Place = <2 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { diffuse 1e30 } translate Place }
#declare Place = <3 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { brilliance 0 } translate Place }
#declare Place = <4 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { brilliance -1 } translate Place }
#declare Place = <5 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { brilliance 1e10 } translate Place }
#declare Place = <6 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 1 phong_size 0 } translate Place }
#declare Place = <7 + 0.5, 3 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 1 phong_size -5 } translate Place }
#declare Place = <0 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { phong -1 } translate Place }
#declare Place = <1 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 1e10 } translate Place }
#declare Place = <2 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { specular 1 roughness 0 } translate Place }
#declare Place = <3 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { specular 1 roughness -0.1 } translate Place }
#declare Place = <4 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { specular 1 roughness 1e10 } translate Place }
#declare Place = <5 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { specular -2 } translate Place }
#declare Place = <6 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 1 metallic -1 } translate Place }
#declare Place = <7 + 0.5, 2 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { phong 1 metallic 5 } translate Place }
#declare Place = <0 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { reflection -0.5 } translate Place }
#declare Place = <1 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { reflection 2 } translate Place }
#declare Place = <2 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { reflection 1e20 } translate Place }
#declare Place = <3 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { reflection { 0.2, 0.8 falloff 0 } } translate Place }
#declare Place = <4 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { reflection { 0.2, 0.8 falloff -1 } } translate Place }
#declare Place = <5 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { reflection { 0.2, 0.8 falloff 1e10 } } translate Place }
#declare Place = <6 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { reflection { 0.5 exponent 0 } } translate Place }
#declare Place = <7 + 0.5, 1 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { reflection { 0.5 exponent -1 } } translate Place }
#declare Place = <0 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { reflection { -0.5 exponent 0.5 } } translate Place }
#declare Place = <1 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { reflection { 0.5 metallic 2 } } translate Place }
#declare Place = <2 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { reflection { 1 } conserve_energy } translate Place }
#declare Place = <3 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { reflection <1, -1, 2> } translate Place }
#declare Place = <4 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { irid { 0.3 thickness 0 turbulence 0 } } translate Place }
#declare Place = <5 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { irid { -1 thickness -1 } } translate Place }
#declare Place = <6 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { specular albedo 1 roughness 0 } translate Place }
#declare Place = <7 + 0.5, 0 + 0.5, 0>;
sphere { 0, 0.46 pigment { rgb <0.9, 0.6, 0.3> } finish { diffuse albedo 1 brilliance 0 } translate Place }
