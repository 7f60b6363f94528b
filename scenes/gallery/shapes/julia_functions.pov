// Hypercomplex fractals of complex functions, whose normals come from the points that the ray has tried.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -20> look_at 0 angle 50 }
light_source { <-5, 8, -20>, 1 }
background { rgb <0.1, 0.2, 0.3> }
#default { pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.5 } }
julia_fractal { <0.3, 0.1, -0.2, 0.05> hypercomplex sin max_iteration 7 precision 30 scale 0.8 translate <-4, 2.6, 0> }
julia_fractal { <0.3, 0.1, -0.2, 0.05> hypercomplex sin max_iteration 5 precision 25 scale <0.8, 0.6, 0.7> translate <4, 2.6, 0> }
julia_fractal { <0.3, 0.2, 0.1, 0.1> hypercomplex pwr(2.2, 0.1) max_iteration 6 precision 25 translate <-4, -3, 0> }
difference {
  box { -1.5, <1.5, 1.5, 0> }
  julia_fractal { <0.3, 0.1, -0.2, 0.05> hypercomplex sin max_iteration 6 precision 25 scale 0.5 }
  translate <4, -3, 0>
}
