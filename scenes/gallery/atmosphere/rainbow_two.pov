// Where two rainbows overlap they are averaged; in a mirror and in fog.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
rainbow { direction <0.1, 0.2, 1> angle 12 width 6 distance 1e4 color_map { [0 rgbft <0.6, 0.2, 0.9, 0, 1>] [0.1 rgbt <0.3, 0.3, 0.9, 0.5>] [0.5 rgbt <0.2, 0.9, 0.2, 0.5>] [0.9 rgbt <0.9, 0.2, 0.1, 0.6>] [1 rgbt <0.9, 0.2, 0.1, 1>] } }
rainbow { direction <-0.1, 0.2, 1> angle 12 width 6 distance 1e4 color_map { [0 rgbft <0.6, 0.2, 0.9, 0, 1>] [0.1 rgbt <0.3, 0.3, 0.9, 0.5>] [0.5 rgbt <0.2, 0.9, 0.2, 0.5>] [0.9 rgbt <0.9, 0.2, 0.1, 0.6>] [1 rgbt <0.9, 0.2, 0.1, 1>] } }
fog { distance 20 rgb 0.6 }
sphere { <-1.2, 0.6, 0>, 0.6 pigment { rgb <0.9, 0.5, 0.3> } finish { phong 0.5 } }
sphere { <1, 0.5, 2>, 0.5 pigment { rgb <0.3, 0.5, 0.9> } finish { reflection 0.5 } }
cylinder { <2.5, 0, 6>, <2.5, 3, 6>, 0.3 pigment { rgb <0.4, 0.8, 0.4> } }
