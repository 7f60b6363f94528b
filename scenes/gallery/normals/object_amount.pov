// The object pattern as a normal without entries, its amount behind the braces.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -7> look_at 0 angle 45 }
light_source { <-7, 9, -11> rgb 1 }
sphere { <-1.3, 0, 0>, 1.2 pigment { rgb <0.9, 0.8, 0.7> }
  normal { object { torus { 0.5, 0.2 rotate 90*x translate -z } } -0.6 accuracy 0.05 translate -1.3*x }
}
sphere { <1.3, 0, 0>, 1.2 pigment { rgb <0.7, 0.8, 0.9> }
  normal { object { box { -0.6, 0.6 rotate <20, 30, 40> translate -0.6*z }
    normal { bumps 0.6 scale 0.1 } normal { wrinkles 1 scale 0.3 } } 0.4 translate 1.3*x }
}
