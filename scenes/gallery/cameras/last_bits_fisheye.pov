// A fractal whose outside is found or missed by the last bits of a ray.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { fisheye location <3, 9, -17> look_at <0, 0.5, 0> angle 40 }
light_source { <-20, 30, -50> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
julia_fractal {
  <0.3, 0.2, -0.2, 0.15> hypercomplex asin max_iteration 4 precision 16
  rotate <20, 40, 0> pigment { rgb <0.9, 0.6, 0.3> }
}
