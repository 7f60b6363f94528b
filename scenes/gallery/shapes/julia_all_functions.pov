// Each complex function of hypercomplex fractals, looked at from outside of the sphere in which they are
// looked for, where the first estimate of the distance is of the place itself.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <2, 1, -60> look_at 0 angle 36 }
light_source { <-20, 30, -50> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
#macro Place(Column, Row)
  max_iteration 4 precision 16 rotate <20, 40, 0>
  pigment { rgb <0.9, 0.6, 0.3> }
  translate <8 * Column - 16, 9 - 9 * Row, 0>
#end
#declare C = <0.3, 0.2, -0.2, 0.15>;
julia_fractal { C hypercomplex exp Place(0, 0) }
julia_fractal { C hypercomplex ln Place(1, 0) }
julia_fractal { C hypercomplex sin Place(2, 0) }
julia_fractal { C hypercomplex cos Place(3, 0) }
julia_fractal { C hypercomplex tan Place(4, 0) }
julia_fractal { C hypercomplex asin Place(0, 1) }
julia_fractal { C hypercomplex acos Place(1, 1) }
julia_fractal { C hypercomplex atan Place(2, 1) }
julia_fractal { C hypercomplex sinh Place(3, 1) }
julia_fractal { C hypercomplex cosh Place(4, 1) }
julia_fractal { C hypercomplex tanh Place(0, 2) }
julia_fractal { C hypercomplex asinh Place(1, 2) }
julia_fractal { C hypercomplex atanh Place(2, 2) }
julia_fractal { C hypercomplex pwr(2.4, 0.2) Place(3, 2) }
julia_fractal { C hypercomplex reciprocal Place(4, 2) }
