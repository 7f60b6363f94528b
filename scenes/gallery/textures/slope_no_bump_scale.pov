// What slope and aoi see under patterned textures with no_bump_scale.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0,0,-5> look_at 0 right x*8 up y*6 }
light_source { <-50, 80, -100> rgb 0.9 }
#declare S = color_map { [0 rgb <0.2, 0.1, 0.4>] [0.5 rgb <0.9, 0.6, 0.2>] [1 rgb <0.2,0.8,0.2>] }
#macro S1(X,Y) sphere { 0,0.95 translate <-3+X*2,2-Y*2,0> #end
#declare N = texture { pigment { slope y color_map { S } } normal { bumps 0.3 scale 0.2 } finish { ambient 1 diffuse 0 } }
#declare M = texture { pigment { slope y color_map { S } } normal { bumps 0.3 scale 0.2 no_bump_scale } finish { ambient 1 diffuse 0 } }
#declare A = texture { pigment { aoi color_map { S } } normal { bumps 0.3 scale 0.2 } finish { ambient 1 diffuse 0 } }
S1(0,0) texture { N } }
S1(1,0) texture { M } }
S1(2,0) texture { N no_bump_scale } }
S1(3,0) texture { A no_bump_scale } }
S1(0,1) texture { gradient x texture_map { [0 N][1 M] } scale 0.5 } }
S1(1,1) texture { gradient x texture_map { [0 N][1 N] } scale 0.5 no_bump_scale } }
S1(2,1) texture { gradient x texture_map { [0 N][1 A] } scale <0.5,1,1> no_bump_scale } }
S1(3,1) texture { gradient x texture_map { [0 N][1 gradient y texture_map { [0 A][1 N] } scale 0.5] } scale <0.5,1,1> no_bump_scale } }
S1(0,2) texture { average texture_map { [1 N][1 gradient y texture_map { [0 A][1 N] } scale 0.5][1 A] } scale <0.5,1,1> } }
S1(1,2) texture { pigment { slope y color_map { S } scale 0.3 } normal { granite 0.3 scale 0.5 no_bump_scale } } }
S1(2,2) pigment { slope y color_map { S } scale 0.3 } normal { gradient x normal_map { [0 bumps 0.3 scale 0.2 no_bump_scale][1 bumps 0.3 scale 0.5] } scale 0.5 } }
S1(3,2) texture { slope y texture_map { [0 N][1 A] } } }
