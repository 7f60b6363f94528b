// An amount behind the modifiers of a uv_mapping normal, and what follows it, has no effect but no_bump_scale.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 40 }
light_source { <-5, 8, -10> rgb 1 }
#default { pigment { rgb <0.8, 0.7, 0.5> } finish { specular 0.3 } }
sphere { <-2, 1.1, 0>, 1 normal { uv_mapping crackle metric 2 scale 0.1 1.5 } }
sphere { <0, 1.1, 0>, 1 normal { uv_mapping bumps 0.4 scale 0.05, 3 scale 9 turbulence 1 } }
sphere { <2, 1.1, 0>, 1 normal { uv_mapping gradient x 0.4 scale 0.05 1.5 no_bump_scale } }
sphere { <-2, -1.1, 0>, 1 normal { uv_mapping crackle 1.5 metric 2 scale 0.1 } }
sphere { <0, -1.1, 0>, 1 normal { uv_mapping bumps 3 scale 0.05 } }
sphere { <2, -1.1, 0>, 1 normal { uv_mapping gradient x 0.4 scale 0.05 } }
