// Indices of refraction, caustics and the dimming of transmitted light in the finish, as old scenes
// have them: in plain textures they overrule the interior, the last member of a union for all.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
#declare G = pigment { rgbt <1, 1, 1, 0.9> };
sphere { <-1.9, 0.6, 0>, 0.5 pigment { G } finish { ambient 0 diffuse 0.1 ior 1.4 caustics 4 } interior { ior 1.1 } }
union { sphere { <-0.7, 0.6, 0>, 0.5 texture { pigment { G } finish { ambient 0 diffuse 0.1 ior 1.5 } } } sphere { <0.3, 0.6, 0>, 0.4 texture { pigment { G } finish { ambient 0 diffuse 0.1 ior 1.2 refraction 0.8 } } } }
sphere { <1.4, 0.6, 0>, 0.5 texture { gradient y texture_map { [0.5 pigment { G } finish { ior 2 refraction 0.2 }] [0.5 pigment { rgbt <1, 0.7, 0.7, 0.9> }] } scale 0.5 } interior { ior 1.3 refraction 0.6 } }
