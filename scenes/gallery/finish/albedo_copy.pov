// A finish that is copied and changed: albedo counts with the brilliance of the end of its block,
// and also for numbers that the same block gives later without the word.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
#declare A = finish { diffuse albedo 0.5 brilliance 4 specular albedo 0.3 roughness 0.05 };
sphere { <-1.95, 0.6, 0>, 0.6 pigment { rgb <0.8, 0.5, 0.3> } finish { A } }
sphere { <-0.65, 0.6, 0>, 0.6 pigment { rgb <0.8, 0.5, 0.3> } finish { A brilliance 1 } }
sphere { <0.65, 0.6, 0>, 0.6 pigment { rgb <0.8, 0.5, 0.3> } finish { A diffuse 0.5 } }
sphere { <1.95, 0.6, 0>, 0.6 pigment { rgb <0.8, 0.5, 0.3> } finish { A roughness 0.01 } }
sphere { <-0.65, 1.75, 0>, 0.4 pigment { rgb 0.5 } finish { phong albedo 0.05 phong 0.02 } }
sphere { <0.65, 1.75, 0>, 0.4 pigment { rgb 0.5 } finish { diffuse albedo 0.5 diffuse 0.2 brilliance 4 } }
