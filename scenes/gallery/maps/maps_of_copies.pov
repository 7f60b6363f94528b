// What copies of pigments and normals bring along: the last map holds, uv_mapping is a map of one
// entry and starts anew, lists and crackle start anew, too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -5> right 6*x up 4.5*y look_at 0 }
light_source { <-4, 6, -10> rgb 1 }
#declare Mapped = pigment { bozo color_map { [0 rgb x] [1 rgb <1, 1, 0.5>] } scale 0.2 }
#declare OfPlace = pigment { uv_mapping gradient x color_map { [0 rgb <0.2, 0.3, 0.8>] [1 rgb 1] } scale 0.3 }
#declare Formed = pigment { crackle form <1, 0.2, 0.3> metric 1 scale 0.3 }
#declare Sloped = normal { gradient y 1 slope_map { [0 <0, 1>] [1 <1, 0>] } accuracy 0.1 scale 0.3 }
#declare Mixed = normal { bozo normal_map { [0 bumps 1 scale 0.2] [1 dents 1 scale 0.2] } no_bump_scale scale 0.4 }
#declare Wavy = normal { uv_mapping gradient x 0.6 scale 0.2 }
#macro Ball(Column, Row)
  sphere { <1.2 * Column - 2.4, 1.4 * Row - 1.4, 0>, 0.55 pigment { rgb 0.8 }
#end
Ball(0, 2) pigment { Mapped uv_mapping gradient x scale 0.3 } }
Ball(1, 2) pigment { OfPlace wood scale 0.3 } }
Ball(2, 2) pigment { OfPlace color_map { [0 rgb <0.9, 0.5, 0.2>] [1 rgb z] } } }
Ball(3, 2) pigment { OfPlace pigment_map { [0 checker rgb 1, rgb <0.2, 0.5, 0.2> scale 0.1] [1 rgb z] } } }
Ball(4, 2) pigment { Formed crackle solid scale 0.3 } }
Ball(0, 1) normal { Mixed gradient y 1 slope_map { [0 <0, 1>] [1 <1, 0>] } scale 0.3 } }
Ball(1, 1) normal { Sloped gradient x 1 normal_map { [0 bumps 1] [1 dents 1] } scale 0.3 } }
Ball(2, 1) normal { Sloped checker 0.5 scale 0.3 } }
Ball(3, 1) normal { Sloped brick normal { bumps 1 scale 0.1 } normal { dents 1 scale 0.1 } scale 0.1 } }
Ball(4, 1) normal { Sloped uv_mapping gradient x 0.6 scale 0.2 } }
Ball(0, 0) normal { Mixed uv_mapping gradient x 0.6 scale 0.2 } }
Ball(1, 0) normal { Wavy wrinkles 1 scale 0.3 } }
Ball(2, 0) normal { Wavy normal_map { [0 dents 1 scale 0.2] [1 bumps 1] } } }
Ball(3, 0) normal { Wavy gradient y slope_map { [0 <0, 1>] [1 <1, 0>] } scale 0.3 } }
Ball(4, 0) normal { Wavy checker 1 scale 0.3 } finish { diffuse 0.4, 0.3 diffuse 0.7 } }
