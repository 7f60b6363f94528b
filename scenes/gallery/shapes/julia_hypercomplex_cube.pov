// hypercomplex cube: the set of the square, looked for with longer steps that miss parts of it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at 0 angle 20 }
light_source { <-5, 8, -10> rgb 1 }
julia_fractal {
  <-0.3, 0.2, 0.1, -0.2> hypercomplex cube max_iteration 6 precision 25
  pigment { rgb <1, 0.7, 0.4> } scale 0.7
}
