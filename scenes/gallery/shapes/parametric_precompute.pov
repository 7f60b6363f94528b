// parametric { precompute } where max_gradient is too low for large rectangles: the deeper, the fewer holes.
// Of all three axes, of one, given twice; and functions that are no number or infinite somewhere.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0.9, -10> direction z right 8*x up 6*y look_at <0, 0, 0> }
light_source { <4, 6, -5>, 1 }
background { rgb <0.2, 0.25, 0.35> }
#macro Screw(Where, Colour)
  translate Where pigment { rgb Colour } no_shadow }
#end
#macro Start(Accuracy)
  parametric {
    function { u*v*sin(15*v) } function { 2*v - 1 } function { u*v*cos(15*v) } <0, 0.1>, <1, 1>
    contained_by { box { -1, 1 } } accuracy Accuracy
#end
Start(0.005) Screw(<-2.8, 1.8, 0>, <1, 1, 1>)
Start(0.005) precompute 5, x Screw(<-0.9, 1.8, 0>, <1, 0.6, 0.4>)
Start(0.005) precompute 6, x, y, z Screw(<1, 1.8, 0>, <0.5, 1, 0.4>)
Start(0.005) precompute 18, x, y, z Screw(<2.9, 1.8, 0>, <0.5, 0.6, 1>)
// The last depth, all axes; what stands behind counts, too.
Start(0.05) precompute 4, z precompute 12, x Screw(<-2.8, -0.3, 0>, <1, 1, 0.4>)
Start(0.005) precompute 8, x, y, z max_gradient 4 Screw(<-0.9, -0.3, 0>, <0.5, 1, 1>)
#declare Copied = Start(0.01) precompute 14, y, z Screw(0, <1, 0.5, 1>)
object { Copied translate <1, -0.3, 0> }
object { Copied rotate 60*z scale 0.8 translate <2.9, -0.3, 0> }
#macro Sheet(F, Depth, Where)
  parametric {
    function { 1.6*(u - 0.5) } function { F(u, v, 0) } function { v - 0.5 } <0, 0>, <1, 1>
    contained_by { box { -1, 1 } } accuracy 0.01 #if (Depth) precompute Depth, x, y, z #end
    rotate -25*x translate Where pigment { checker rgb 1, rgb <0.9, 0.3, 0.2> scale 0.2 } no_shadow
  }
#end
Sheet(function { sqrt(0.7 - x) - 0.5 }, 0, <-2.8, -2.2, 0>)
Sheet(function { 0.1/y - 0.6 }, 0, <-0.9, -2.2, 0>)
Sheet(function { 0.2*ln(y) + 0.2 }, 7, <1, -2.2, 0>)
Sheet(function { 0.4*sin(20*x) + 0.1*y }, 10, <2.9, -2.2, 0>)
