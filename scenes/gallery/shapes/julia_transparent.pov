// Rays that go through the inside of quaternion fractals: steps as short as the precision there.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 0, -9> look_at 0 angle 50 }
light_source { <-5, 8, -10>, 1 }
light_source { <6, -3, -8>, 0.4 shadowless }
background { rgb <0.1, 0.2, 0.3> }
#default { pigment { rgbt <0.9, 0.7, 0.4, 0.7> } finish { phong 0.5 } }
julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 10 precision 1000 translate <-3, 1.8, 0> }
julia_fractal { <0.4, 0.1, 0.1, -0.2> quaternion cube max_iteration 8 precision 300 rotate 40*y translate <0, 1.8, 0> }
julia_fractal { <0, 0, 0, 0> max_iteration 20 precision 100 slice <0.2, 0.1, 0, 0.05>, 0.1 translate <3, 1.8, 0> }
julia_fractal { <-0.2, 0.4, -0.4, -0.4> max_iteration 9 precision 200 slice <0.1, 0.2, 0, 1>, 0.1 translate <-3, -1.8, 0> }
difference {
  box { -1, <1, 1, 0.5> pigment { rgbt <0.4, 0.5, 0.9, 0.6> } }
  julia_fractal { <-0.083, 0, -0.83, -0.025> cube max_iteration 7 precision 150 scale 0.8 }
  rotate 30*y translate <0, -1.8, 0>
}
julia_fractal { <0.3, 0.5, 0.2, 0> max_iteration 1 precision 50 scale <1, 0.6, 0.8> translate <3, -1.8, 0> }
