// Mirrors below a sky of onion, whose colour jumps at the length 1 that every direction has: ellipsoids, an
// isosurface, smooth triangles scaled, a mesh of flat and smooth faces. One last digit of a normal changes a pixel.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-0.5, 0.83, -6> look_at 0 angle 50 }
sky_sphere { pigment { onion } }
#default { texture { pigment { rgb 0 } finish { ambient 0 diffuse 0 reflection 1 } } }
sphere { <0.1, 0.2, 0.3>, 0.9 scale <1.2, 0.8, 0.9> translate <-1.7, 0.7, 0> }
sphere { <0.1, 0.2, 0.3>, 0.8 rotate <20, 30, 40> scale <1.2, 0.8, 0.9> translate <-1.7, -1.1, 0> }
isosurface {
  function { x*x + y*y*1.3 + z*z*0.8 - 0.6 + 0.05*sin(x*9) }
  contained_by { box { -1, 1 } } max_gradient 5
  translate <0.3, 0.8, 0>
}
smooth_triangle {
  <-1, -0.8, 0.2>, <-0.4, -0.3, -1>, <1, -0.7, 0>, <0.3, -0.4, -1>, <0.1, 1, 0.3>, <0, 0.5, -0.9>
  scale 0.8 translate <0.3, -1, 0>
}
mesh {
  triangle { <-1, -0.8, 0.2>, <1, -0.7, 0>, <0.1, 1, 0.3> }
  smooth_triangle {
    <-1, -0.8, -0.2>, <-0.4, -0.3, -1>, <1, -0.7, -0.4>, <0.3, -0.4, -1>, <0.1, 0.3, 0.3>, <0, 0.5, -0.9>
  }
  translate <2, 0.9, 0>
}
mesh {
  triangle { <1.1, -1.9, 0.2>, <3.1, -1.7, 0>, <2.1, 0, 0.3> }
  smooth_triangle {
    <1.1, -1.9, -0.2>, <-0.4, -0.3, -1>, <3.1, -1.7, -0.4>, <0.3, -0.4, -1>, <2.1, -0.8, 0.3>, <0, 0.5, -0.9>
  }
}
