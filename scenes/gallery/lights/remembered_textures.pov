// What shadows itself from less than 0.001 away: only opaque textures that say so at once are remembered as
// what stopped the light last. Julia sets with a plain texture, one by uv, an average and a texture_map.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 250, -600> look_at <0, 40, 0> angle 30 }
light_source { <50, 1000, -700> rgb 1 }
#macro Julia(Place)
  julia_fractal {
    <0.1, 0.8, -0.1, 0.01> quaternion sqr max_iteration 8 precision 1000
    scale 50 translate Place rotate 0
#end
Julia(<-75, 100, 0>) pigment { rgb 1 } }
Julia(<75, 100, 0>) texture { uv_mapping pigment { rgb <1, .9, .7> } } }
Julia(<-75, -15, 0>) texture { average texture_map { [1 pigment { rgb 1 }] [1 pigment { rgb x }] } } }
Julia(<75, -15, 0>)
  texture { gradient y texture_map { [0 pigment { rgb <.5, .7, 1> }] [1 pigment { rgb 1 }] } scale 50 } }
