// bump_map with no_bump_scale: where the surface faces up, a normal that scaling has shortened is
// taken for one that points down.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -9> look_at <0, -0.5, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
#default { pigment { rgb <0.85, 0.8, 0.7> } finish { ambient 0.2 phong 0.4 phong_size 30 } }
#declare Bumps = normal { bump_map { pgm "bump.pgm" bump_size 3 } rotate 90*x scale 0.4 no_bump_scale }
#declare Plain = normal { bump_map { pgm "bump.pgm" bump_size 3 } scale 0.4 no_bump_scale }
plane { y, -1.2 normal { Plain } }
box { <-3, -1.1, -1>, <-1, 0, 1> normal { Plain } }
box { <-0.8, -1.1, -1>, <0.8, 0, 1> normal { Bumps } }
box { <1.1, -1.1, -1>, <3, 0, 1> normal { bump_map { pgm "bump.pgm" bump_size 3 } scale <2, 0.5, 1> no_bump_scale } }
sphere { <0, 0.9, 0>, 0.8 normal { Plain } }
