// bump_map with no_bump_scale as an entry of normal_map and average: it keeps the length that
// scaling gave it, and its share of the sum with it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -9> look_at <0, -0.1, 0> angle 44 }
light_source { <-5, 8, -10> rgb 0.9 }
#default { pigment { rgb <0.85, 0.8, 0.7> } finish { ambient 0.2 phong 0.4 phong_size 30 } }
#declare Image = normal { bump_map { pgm "bump.pgm" bump_size 4 } scale 0.4 no_bump_scale }
#declare Coarse = normal { bump_map { pgm "bump.pgm" bump_size 4 } scale 1.7 no_bump_scale }
#declare Noise = normal { bumps 0.8 scale 0.2 no_bump_scale }
sphere { <-2.2, 1.1, 0>, 1 normal { bozo normal_map { [0 Image] [1 Noise] } } }
sphere { <0, 1.1, 0>, 1 normal { average normal_map { [1 Image] [2 Coarse] } } }
sphere { <2.2, 1.1, 0>, 1 normal { average normal_map { [1 Coarse] [1 Noise] } scale <0.6, 1, 1.3> } }
sphere { <-2.2, -1.3, 0>, 1 normal { gradient y normal_map { [0 Coarse] [1 Image] } no_bump_scale } }
sphere { <0, -1.3, 0>, 1 normal { radial normal_map { [0 Noise] [0.5 Image] [1 Noise] } } scale 0.999 }
sphere {
  <2.2, -1.3, 0>, 1
  normal { average normal_map { [1 bump_map { pgm "bump.pgm" bump_size 4 } scale 0.4] [1 bumps 0.8 scale 0.3] } scale 1.3 no_bump_scale }
}
