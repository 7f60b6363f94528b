// Bodies that overlap belong to the one entered last; members of one union share an interior, so the
// second entry counts as leaving; a merge has no inner walls.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
global_settings { max_trace_level 12 }
sphere { <-1.9, 0.6, 0>, 0.5 pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.5 } } box { <-1.7, 0.2, -0.3>, <-1, 0.9, 0.3> pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.2 } }
union { sphere { <-0.2, 0.6, 0>, 0.5 } box { <0, 0.2, -0.3>, <0.6, 0.9, 0.3> } pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.5 } }
merge { sphere { <1.4, 0.6, 0>, 0.5 } box { <1.6, 0.2, -0.3>, <2.2, 0.9, 0.3> } pigment { rgbt <1, 1, 1, 0.95> } finish { ambient 0 diffuse 0.1 specular 0.5 } interior { ior 1.5 } }
