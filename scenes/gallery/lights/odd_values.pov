// Values at the ends of what lights accept; each light shines on its own square only.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <3.0, 2.0, -20> look_at <3.0, 2.0, 0> up 4.5*y right 6*x }
light_source { <-30, 50, -60>, 1 }
background { rgb <0.2, 0.3, 0.5> }
#declare Place = <0 + 0.5, 3 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 spotlight point_at 0 radius 30 falloff 10 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <1 + 0.5, 3 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 spotlight point_at 0 radius 0 falloff 0 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <2 + 0.5, 3 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 spotlight point_at <0.3, 1, -3> radius 10 falloff 20 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <3 + 0.5, 3 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 spotlight point_at 0 radius -10 falloff 20 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <4 + 0.5, 3 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 spotlight point_at 0 radius 10 falloff 100 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <5 + 0.5, 3 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 spotlight point_at 0 radius 10 falloff 20 tightness 0 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <0 + 0.5, 2 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 spotlight point_at 0 radius 10 falloff 20 tightness -10 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <1 + 0.5, 2 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 cylinder point_at 0 radius 0.4 falloff 0.2 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <2 + 0.5, 2 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 cylinder point_at 0 radius -1 falloff 0.3 tightness -5 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <3 + 0.5, 2 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 parallel point_at <0.3, 1, -3> } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <4 + 0.5, 2 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 area_light x, y, 1, 1 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <5 + 0.5, 2 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 area_light 0, 0, 4, 4 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <0 + 0.5, 1 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 area_light x, x, 4, 4 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <1 + 0.5, 1 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 area_light x, y, 4, 1 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <2 + 0.5, 1 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 area_light x, y, 2, 2 circular orient } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <3 + 0.5, 1 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 area_light x, y, 3, 3 adaptive 100 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <4 + 0.5, 1 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 area_light 0, 0, 3, 3 area_illumination circular orient } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <5 + 0.5, 1 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 fade_distance 0 fade_power 2 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <0 + 0.5, 0 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 fade_distance 3 fade_power 0 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <1 + 0.5, 0 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 fade_distance 3 fade_power -1 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <2 + 0.5, 0 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 fade_distance -3 fade_power 2 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <3 + 0.5, 0 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 fade_distance 1e-30 fade_power 5 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <4 + 0.5, 0 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 scale 0 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
#declare Place = <5 + 0.5, 0 + 0.5, 0>;
light_group { light_source { <0.3, 1, -3>, 1 rotate 1e10 } box { <-0.46, -0.46, 0>, <0.46, 0.46, 0.1> pigment { rgb 0.8 } } sphere { <0, 0, -0.2>, 0.2 pigment { rgb <0.9, 0.6, 0.3> } } global_lights off translate Place }
