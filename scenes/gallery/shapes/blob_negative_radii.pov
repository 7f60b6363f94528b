// Radii of blobs count by their amount: only their squares are used.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -6> look_at 0 angle 40 }
light_source { <-6, 8, -10>, 1 }
background { rgb <0.1, 0.15, 0.25> }
#default { pigment { rgb <0.9, 0.65, 0.3> } }
blob { threshold 0.4 sphere { <-1.2, 0.3, 0>, -1, 1 } sphere { <-0.5, 0.3, 0>, 0.8, 1 } cylinder { <0.4, -0.8, 0>, <1.4, 0.8, 0>, -0.7, 1 } }
difference { blob { threshold 0.5 sphere { <-1, -1, 0>, -1.2, 1.5 scale <1, 0.7, 1> } } box { <-1, -2, -2>, <1, 0, 2> } pigment { rgb <0.4, 0.7, 0.9> } }
