// Maps of one entry, of equal and of falling places, of values out of 0 to 1; averages of no and of negative weight.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <3.0, 2.0, -20> look_at <3.0, 2.0, 0> up 4.5*y right 6*x }
light_source { <-30, 50, -60>, 1 }
background { rgb <0.2, 0.3, 0.5> }
#default { finish { ambient 1 diffuse 0 } }
#declare Place = <0 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x color_map { [0.5 rgb 1] } scale 2 translate -1 } translate Place }
#declare Place = <1 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x color_map { [0.5 rgb x] [0.5 rgb y] } scale 2 translate -1 } translate Place }
#declare Place = <2 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x color_map { [0.8 rgb x] [0.2 rgb y] } scale 2 translate -1 } translate Place }
#declare Place = <3 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x color_map { [-5 rgb x] [5 rgb y] } scale 2 translate -1 } translate Place }
#declare Place = <4 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x color_map { [0 rgb x] [0 rgb y] [1 rgb z] [1 rgb 1] } scale 2 translate -1 } translate Place }
#declare Place = <5 + 0.5, 3 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x color_map { [0.3 rgb x] [0.3 rgb y] [0.3 rgb z] } scale 2 translate -1 } translate Place }
#declare Place = <0 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x color_map { [1 rgb x] [0 rgb z] } scale 2 translate -1 } translate Place }
#declare Place = <1 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x color_map { [0 rgb -1] [1 rgb 1e30] } scale 2 translate -1 } translate Place }
#declare Place = <2 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x color_map { [0 rgb x] [1 rgbt <0, 0, 1, 2>] } scale 2 translate -1 } translate Place }
#declare Place = <3 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x color_map { [0 rgb x] [1 rgbf <0, 0, 1, -2>] } scale 2 translate -1 } translate Place }
#declare Place = <4 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x color_map { [0 rgb x] [1/3 rgb y] [1/3 rgb z] [2 rgb 0] } scale 2 translate -1 } translate Place }
#declare Place = <5 + 0.5, 2 + 0.5, 0>;
box { -0.46, 0.46 pigment { gradient x pigment_map { [0.7 granite] [0.2 rgb x] } scale 2 translate -1 } translate Place }
#declare Place = <0 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { average pigment_map { [0 rgb x] [0 rgb y] } } translate Place }
#declare Place = <1 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { average pigment_map { [1 rgb x] [-1 rgb y] } } translate Place }
#declare Place = <2 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { average pigment_map { [2 rgb x] [-1 rgb y] } } translate Place }
#declare Place = <3 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 pigment { average pigment_map { [1e30 rgb x] [1e30 rgb y] } } translate Place }
#declare Place = <4 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 texture { gradient x texture_map { [0.4 pigment { rgb x }] } } translate Place }
#declare Place = <5 + 0.5, 1 + 0.5, 0>;
box { -0.46, 0.46 texture { gradient x texture_map { [0.8 pigment { rgb x }] [0.2 pigment { rgb z }] } scale 2 translate -1 } translate Place }
#declare Place = <0 + 0.5, 0 + 0.5, 0>;
box { -0.46, 0.46 texture { average texture_map { [0 pigment { rgb x }] [0 pigment { rgb z }] } } translate Place }
