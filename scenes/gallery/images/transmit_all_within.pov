// Within maps, lists, averages and uv_mapping an image counts as opaque in spite of `transmit all`.
#version 3.7; 
global_settings { assumed_gamma 1 } 
camera { orthographic location <0,10,-10> look_at 0 right 8*x up 6*y }
light_source { <-10,20,-5> rgb 1 }
plane { y,-1 pigment { rgb 1 } }
#declare I = pigment { image_map { png "rgb.png" transmit all 0.5 } };
sphere { 0,.8 pigment { uv_mapping image_map { png "rgba.png" } } translate <-3,0,2> }
sphere { 0,.8 pigment { uv_mapping gradient x pigment_map { [0 I][1 I] } } translate <-1,0,2>}
sphere { 0,.8 pigment { gradient x pigment_map { [0 uv_mapping image_map { png "rgb.png" transmit all 0.5 }] [1 rgb 1] } } translate <1,0,2> }
sphere { 0,.8 pigment { gradient x pigment_map { [0 uv_mapping image_map { png "rgb.png" transmit all 0.5 }] [1 rgbt .5] } } translate <3,0,2> }
sphere { 0,.8 texture { uv_mapping pigment { image_map { png "rgb.png" transmit all 0.5 } } } translate <-3,0,0> }
sphere { 0,.8 texture { pigment { uv_mapping image_map { png "rgb.png" transmit all 0.5 } } } texture { pigment { rgbt .9 } } translate <-1,0,0> }
sphere { 0,.8 pigment { gradient x pigment_map { [0 I] [1 I] } } translate <1,0,0> }
sphere { 0,.8 pigment { checker pigment { uv_mapping image_map { png "rgb.png" transmit all 0.5 } } pigment { rgb 1 } scale .3 } translate <3,0,0> }
sphere { 0,.8 pigment { average pigment_map { [1 I] [1 I] } } translate <-3,0,-2> }
sphere { 0,.8 pigment { uv_mapping average pigment_map { [1 I] [1 rgb 1] } } translate <-1,0,-2> }
sphere { 0,.8 pigment { uv_mapping gradient x pigment_map { [0 I][1 rgb 1] } } translate <1,0,-2>}
sphere { 0,.8 pigment { uv_mapping gradient x color_map { [0 rgbt 1][1 rgb <1,0,0>] } } translate <3,0,-2>}
