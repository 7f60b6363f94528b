// Cuts through joints of the curve: whether the points of a face lie in the prism or lathe is decided
// by the last bits of a root, with sturm by those of another method.
#version 3.7; global_settings{assumed_gamma 1}
camera{location <0,4,-9> look_at 0 angle 35}
light_source{<-5,8,-10>,1} light_source{<5,-2,-8>,.4}
#default{pigment{rgb<.9,.6,.3>} finish{ambient .1 phong .6}}
#declare Cutter = box { <0, -1, -2>, <2, 3, 0> }
difference {
  prism {
    conic_sweep cubic_spline 0.3, 1.5, 8
    <-1, 0>, <0, -1>, <1, 0>, <0.5, 0.6>, <0, 1>, <-1, 0.3>, <0, -1>, <1, 0>
  }
  object { Cutter }
  translate <-2.5, 0.3, 0>
}
difference {
  prism {
    conic_sweep cubic_spline 0.3, 1.5, 8
    <-1, 0>, <0, -1>, <1, 0>, <0.5, 0.6>, <0, 1>, <-1, 0.3>, <0, -1>, <1, 0> sturm
  }
  object { Cutter }
  translate <0.8, 0.3, 0>
}
difference {
  lathe {
    cubic_spline 7
    <0, -1.5>, <0, -1.1>, <1, -0.9>, <0.5, 0>, <0.6, 0.5>, <0, 1>, <0, 1.3>
  }
  object { Cutter translate y }
  translate <-1, -1.2, -1>
}
difference {
  lathe {
    cubic_spline 7
    <0, -1.5>, <0, -1.1>, <1, -0.9>, <0.5, 0>, <0.6, 0.5>, <0, 1>, <0, 1.3> sturm
  }
  object { Cutter translate y }
  translate <1.6, -1.2, -1>
}
