// Boxes take translate and scale into their corners, but rotate, matrix and transform as a matrix,
// whatever these do. So the faces of a box and of what is cut from it lie in one plane or nearly so,
// and the grain on them shows which (spec/geometry.md 3). Spheres, planes and sweeps do alike.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 2.5, -9> look_at <0.2, 0.1, 0> angle 50 }
light_source { <-5, 10, -8> rgb 1 }
plane { y, -2.4 pigment { hexagon rgb 1 rgb <0.8, 0.2, 0.2> rgb <0.2, 0.2, 0.8> scale 0.5 } }

#macro Move_Of(Kind)
  #switch (Kind)
    #case (0) rotate 0 #break
    #case (1) scale 1 translate 0 #break
    #case (2) matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5, 0, 0> translate -0.5*x #break
    #case (3) matrix <2, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0> scale 0.5 #break
    #case (4) transform { scale 2 } scale 0.5 #break
    #case (5) transform { translate 0 } #break
  #end
#end

#for (K, 0, 5)
  difference {
    box { -1, 1 }
    #for (X, -4, 4, 2)
      box { <X - 0.5, 3.5, -10>/4.5, <X + 0.5, 4.5, 10>/4.5 Move_Of(K) }
      box { <3.5, X - 0.5, -10>/4.5, <4.5, X + 0.5, 10>/4.5 Move_Of(K) }
    #end
    pigment { rgb 1 }
    rotate y*10*K
    scale 0.9
    rotate <-20, 40, 10>
    translate <2.9*mod(K, 3) - 2.7, 1.5 - 2.9*div(K, 3), 0>
  }
#end
