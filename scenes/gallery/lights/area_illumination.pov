// With area_illumination each point of the grid lights the surface from its own direction, fades by
// itself, and gives a highlight of its own.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
sphere { <-1, 0.6, 0>, 0.6 pigment { rgb <0.9, 0.4, 0.3> } finish { specular 0.5 roughness 0.02 } }
sphere { <0.9, 0.4, -0.8>, 0.4 pigment { rgb <0.3, 0.6, 0.9> } finish { phong 0.6 } }

light_source { <0.5, 1.5, -1.5> rgb 1 area_light <2.5, 0, 0>, <0, 0, 1>, 5, 2 area_illumination on fade_distance 1.5 fade_power 2 }
