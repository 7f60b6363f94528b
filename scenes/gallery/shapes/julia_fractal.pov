// Quaternion and hypercomplex fractals, sliced, cut, cutting, turned.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -9> look_at 0 angle 50 }
light_source { <-5, 8, -10>, 1 }
light_source { <6, -3, -8>, 0.4 shadowless }
background { rgb <0.1, 0.2, 0.3> }
#default { pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.5 } }
julia_fractal { <-0.083, 0.0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 15 translate <-3, 1.8, 0> }
julia_fractal { <-0.162, 0.163, 0.56, -0.599> hypercomplex sqr max_iteration 8 precision 15 translate <0, 1.8, 0> }
julia_fractal { <0.4, 0.1, 0.1, -0.2> cube max_iteration 6 precision 30 rotate 40*y translate <3, 1.8, 0> }
difference {
  julia_fractal { <-0.083, 0.0, -0.83, -0.025> max_iteration 8 precision 20 slice <0.1, 0.2, 0, 1>, 0.1 }
  plane { z, 0 pigment { checker rgb 1, rgb <0.8, 0.2, 0.2> scale 0.2 } }
  rotate 20*y translate <-3, -1.8, 0>
}
difference {
  box { -1, <1, 1, 0.5> pigment { rgb <0.4, 0.5, 0.9> } }
  julia_fractal { <-0.083, 0.0, -0.83, -0.025> max_iteration 8 precision 20 scale 0.8 }
  rotate 30*y translate <0, -1.8, 0>
}
julia_fractal { <0.4, 0.1, 0.1, -0.2> max_iteration 7 precision 20
  uv_mapping pigment { checker rgb 1, rgb <0.2, 0.5, 0.2> scale 0.2 } scale <1, 0.6, 0.8> translate <3, -1.8, 0> }
