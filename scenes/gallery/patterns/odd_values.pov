// Values at the ends of what patterns accept: no directions, no sizes, functions that are no numbers.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <4.0, 2.5, -20> look_at <4.0, 2.5, 0> up 6*y right 8*x }
light_source { <-30, 50, -60>, 1 }
background { rgb <0.2, 0.3, 0.5> }
#default { finish { ambient 1 diffuse 0 } }
#declare Place = <0 + 0.5, 4 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient 0 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <1 + 0.5, 4 + 0.5, 0>;
box { -0.46, 0.46 pigment { agate agate_turb 0 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <2 + 0.5, 4 + 0.5, 0>;
box { -0.46, 0.46 pigment { spiral1 0 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <3 + 0.5, 4 + 0.5, 0>;
box { -0.46, 0.46 pigment { spiral2 -3 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <4 + 0.5, 4 + 0.5, 0>;
box { -0.46, 0.46 pigment { crackle metric 0 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <5 + 0.5, 4 + 0.5, 0>;
box { -0.46, 0.46 pigment { crackle metric -1 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <6 + 0.5, 4 + 0.5, 0>;
box { -0.46, 0.46 pigment { crackle offset -10 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <7 + 0.5, 4 + 0.5, 0>;
box { -0.46, 0.46 pigment { crackle form 0 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <0 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { mandel 1 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <1 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { mandel 1000 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <2 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { julia <1e10, 0>, 10 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <3 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { magnet 2 julia <0, 0>, 5 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <4 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { mandel 20 exterior 1, 1e30 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <5 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { mandel 20 exponent 33 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <0 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { slope { y, 0.5, 0.5 } color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <2 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { slope { y, 0, 1 altitude y, 0, 0 } color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <3 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { radial frequency 0 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <4 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { radial frequency -6 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <5 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { function { 1/0 } color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <6 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { function { x/x*0 + 0/x } color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <7 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { function { ln(x) } color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <0 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { function { pow(x, 0.5) } color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <1 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { function { 1e300*1e300*x } color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <2 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { function { acos(2*x) } color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <3 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { function { mod(x, 0) } color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <4 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { function { exp(1000*x) } color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <5 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo frequency -2 phase -7 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <6 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { bozo poly_wave 0 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <7 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x poly_wave -0.5 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <0 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x sine_wave frequency 0 phase 0.3 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <1 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { boxed scale 0.0001 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <2 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { planar frequency 2 ramp_wave phase -1e6 color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <3 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { cylindrical scale <0, 1, 0> color_map { [0 rgb x] [0.5 rgb y] [1 rgb z] } scale 0.4 } translate Place }
#declare Place = <4 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { brick mortar 10 } translate Place }
#declare Place = <5 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { brick brick_size -1 } translate Place }
#declare Place = <6 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { object { sphere { 0, 0 } rgb x rgb y } } translate Place }
#declare Place = <7 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 pigment { brick rgb 1 rgb <1, 0, 0> brick_size <0, 0.3, 0.3> mortar 0.05 } translate Place }
