// Rays along z in the planes of boxes' faces (pixel centres at odd multiples of 1/32): objects whose
// own box is asked are missed in its faces across x, by shadow rays, too; spheres, boxes, planes,
// triangles, and faces across y are met.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 0, -10> look_at 0 right 10*x up 7.5*y }
light_source { <0, 0, -100>, 1 parallel point_at 0 }
plane { z, 3 pigment { checker rgb 0.8, rgb <0.4, 0.5, 0.6> } finish { ambient 0.1 diffuse 0.6 } }
#declare A = 25/32;
#macro At(X, Y) translate <2.5 * X, 2.5 * Y, 0> pigment { rgb <0.9, 0.6, 0.3> } #end
#declare Square = prism { -A, A, 5, <-A, -A>, <A, -A>, <A, A>, <-A, A>, <-A, -A> }
#declare Both = intersection { box { -A, A } box { -A, A + 1 } }
#declare Middle = <0.123, 0.277, 0>;
#declare Panes = mesh {
  triangle { <-A, -A, 0>, <A, -A, 0>, Middle }
  triangle { <A, -A, 0>, <A, A, 0>, Middle }
  triangle { <A, A, 0>, <-A, A, 0>, Middle }
  triangle { <-A, A, 0>, <-A, -A, 0>, Middle }
}
#declare Sheet = quadric { <0, 0, 1>, <0, 0, 0>, <0, 0, 0>, -0.1 clipped_by { box { -A, A } } }
object { Square At(-1.5, 1) }
object { Both At(-0.5, 1) }
object { Panes At(0.5, 1) }
object { Sheet At(1.5, 1) }
box { -A, A At(-1.5, 0) }
plane { z, 0 clipped_by { box { -A, A } } At(-0.5, 0) }
difference { box { -A, A } sphere { <0, 0, -A>, 0.4 } At(0.5, 0) }
bicubic_patch {
  type 0 flatness 0.1 u_steps 1 v_steps 1
  #for (I, 0, 3) #for (J, 0, 3) <-A + J * A / 1.5, -A + I * A / 1.5, 0> #end #end
  At(1.5, 0)
}
object { Square no_image At(-1.5, -1) }
object { Both no_image At(-0.5, -1) }
object { Panes no_image At(0.5, -1) }
object { Both no_image translate <3.75, -2.5, 0> pigment { rgbt <0.9, 0.6, 0.3, 0.5> } }
