// area_illumination without area_light: a warning, and surfaces that face away are lit, too.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }
sphere { <-1, 0.6, 0>, 0.6 pigment { rgb <0.9, 0.4, 0.3> } finish { specular 0.5 roughness 0.02 } }
sphere { <0.9, 0.4, -0.8>, 0.4 pigment { rgb <0.3, 0.6, 0.9> } finish { phong 0.6 } }

light_source { <1.5, 2, 2.5> rgb 0.8 area_illumination on }
