// isosurface with evaluate: rays start from the gradient that earlier ones have found.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <6, 4, -10> look_at 0 right 5.2*x up 3.9*y }
light_source { <-6, 8, -10>, 1 }
light_source { <7, 2, -6>, rgb 0.35 shadowless }
background { rgb <0.1, 0.15, 0.25> }
#default { pigment { rgb <0.9, 0.65, 0.3> } finish { ambient 0.1 diffuse 0.7 phong 0.6 phong_size 30 } }
#declare Curves = function {
  pow(2.92*(x - 1)*x*x*(x + 1) + 1.7*y*y, 2)*pow(y*y - 0.88, 2) + pow(2.92*(y - 1)*y*y*(y + 1) + 1.7*z*z, 2)*pow(z*z - 0.88, 2)
  + pow(2.92*(z - 1)*z*z*(z + 1) + 1.7*x*x, 2)*pow(x*x - 0.88, 2) - 0.02
}
isosurface { function { Curves(x, y, z) } open evaluate 0.18, 1.5, 0.7 translate <-1.2, 0, 0> }
isosurface { function { 4*(x*x + y*y + z*z - 0.36) + 0.5*sin(20*z) } evaluate 0.5, 1.2, 0.9 scale 1.2 translate <1.3, 0.8, 0> }
isosurface { function { pow(x*x*4 + y*y*9, 2) + z*z - 0.6 } contained_by { sphere { 0, 1.2 } } max_gradient 0.5 evaluate 1, 10, 0.1 rotate 50*y translate <1.5, -0.9, 0> }
