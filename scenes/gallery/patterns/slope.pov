// slope: direction, range, altitude, point_at; it sees the bumps of its own texture.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2.5, -9> look_at <0, 0.1, 0> angle 42 }
light_source { <-5, 8, -10> rgb 0.6 }
#default { finish { ambient 0.6 diffuse 0.5 } }
#declare Ramp = color_map { [0 rgb <0.1, 0.1, 0.4>] [0.5 rgb <0.2, 0.7, 0.3>] [0.7 rgb <1, 0.9, 0.4>] [1 rgb 1] }
#macro Thing(I, P, N)
  union {
    sphere { 0, 0.8 }
    torus { 0.9, 0.2 rotate 20*x }
    texture { pigment { P color_map { Ramp } } normal { N } }
    translate <2.1 * (mod(I, 3) - 1), 1.2 - 2.3 * div(I, 3), 0>
  }
#end
Thing(0, pigment { slope y }, normal { bumps 0 })
Thing(1, pigment { slope { <1, 1, 0>, 0.3, 0.9 } }, normal { bumps 0.4 scale 0.2 })
Thing(2, pigment { slope { y, 0, 0.5 altitude y, -1, 1 } }, normal { ripples 0.3 scale 0.3 })
Thing(3, pigment { slope { point_at <0, 5, -5> } }, normal { bumps 0.4 scale 0.2 no_bump_scale })
Thing(4, pigment { slope -z frequency 3 }, normal { granite 0.2 })
Thing(5, pigment { slope { <0, 2, 0> altitude <1, 1, 0>, 0, 2 } scale 0.5 rotate 40*z }, normal { bumps 0 })
