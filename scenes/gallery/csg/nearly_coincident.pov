// Faces that lie in one plane but for the last digits of their depths: what povray does not test, since
// its box lies beyond the hit so far, does not show even where it is nearer.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.2, -3, -4> look_at <0, 0.2, 0> angle 60 }
background { rgb 0.2 }
#macro Place(Height, Turn, Where, Colour)
  rotate Turn * y translate Where + (0.3 + Height) * y pigment { rgb Colour } finish { ambient 1 diffuse 0 }
#end
#declare I = 0;
#while (I < 4)
  #declare J = 0;
  #while (J < 4)
    #declare Where = <J - 1.6, 0, I - 1.2>;
    box { <-0.4, -0.6, -0.4>, <0.4, 0.6, 0.4> Place(0.6, 7 * I, Where, <1, I / 4, J / 4>) }
    cylinder { -0.5 * y, 0.5 * y, 0.4 Place(0.5, 8, Where - <0.2, 0, 0.1>, <I / 4, 1, J / 4>) }
    difference {
      box { <-0.3, -0.7, -0.3>, <0.3, 0.7, 0.3> } cylinder { -y, y, 0.1 }
      Place(0.7, 11 * J, Where + <0.3, 0, 0.2>, <I / 4, J / 4, 1>)
    }
    #declare J = J + 1;
  #end
  #declare I = I + 1;
#end
