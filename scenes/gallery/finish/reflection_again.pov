// A second reflection{} or irid{}, here after a declared finish: what it leaves out stays as the first said.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.6, -6> right 4/3*x look_at <0, 0.5, 0> angle 42 }
light_source { <-3, 5, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.8 rgb <0.3, 0.25, 0.2> } finish { ambient 0.1 diffuse 0.7 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [0.5 rgb <0.3, 0.5, 0.9>] [1 rgb <0.1, 0.1, 0.5>] } } }
#declare Metal = finish { diffuse 0.3 reflection { 0.6 metallic 0.9 falloff 3 exponent 1.3 } }
#declare Glazed = finish { diffuse 0.3 reflection { 0, 0.9 fresnel } }
#declare Film = finish { irid { 0.4 thickness 0.5 turbulence 0.2 } }
#default { pigment { rgb <0.8, 0.5, 0.3> } }
sphere { <-1.95, 0.6, 0>, 0.6 finish { Metal reflection { 0.4 } } interior { ior 1.5 } }
sphere { <-0.65, 0.6, 0>, 0.6 finish { Metal reflection { 0.1, 0.8 metallic off } } interior { ior 1.5 } }
sphere { <0.65, 0.6, 0>, 0.6 finish { Metal reflection 0.5 } interior { ior 1.5 } }
sphere { <1.95, 0.6, 0>, 0.6 finish { Glazed reflection { 0.3, 1 } } interior { ior 1.5 } }
sphere { <-1.3, 1.7, 0.5>, 0.6 finish { Glazed reflection { 0.3 } } interior { ior 1.5 } }
sphere { <0, 1.7, 0.5>, 0.6 finish { Glazed reflection { 0.3, 1 fresnel off } } interior { ior 1.5 } }
sphere { <1.3, 1.7, 0.5>, 0.6 finish { Metal reflection { 0.9 fresnel falloff 1 } } interior { ior 1.5 } }
sphere { <2.4, 1.7, 0.5>, 0.5 finish { Glazed reflection 0.1 reflection { 0.1, 0.8 } } interior { ior 1.5 } }
sphere { <-2.4, 1.7, 0.5>, 0.5 finish { Film irid { 0.3 } } interior { ior 1.5 } }
