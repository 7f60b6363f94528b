#version 3.7;
global_settings { assumed_gamma 2.2 }
#include "colors.inc"
#include "rand.inc"
#declare R1 = seed(1234);
#declare Leaves = 0;
#macro Branch(Level, Len, Rad, M)
  #local Dir = vrotate(y, M);
  #local Tip = Dir * Len;
  cone { 0, Rad, Tip, Rad * 0.7 pigment { rgb <0.4, 0.25, 0.1> * (1 + 0.1 * Level) } }
  #if (Level > 0)
    #local N = 2 + int(rand(R1) * 2.5);
    #for (K, 1, N)
      #local A = <rand(R1) * 70 - 35, 360 * K / N + rand(R1) * 40, rand(R1) * 70 - 35>;
      union { Branch(Level - 1, Len * (0.65 + rand(R1) * 0.2), Rad * 0.65, A) translate Tip }
    #end
  #else
    #declare Leaves = Leaves + 1;
    disc { Tip, VRand_On_Sphere(R1), Len * 0.6 pigment { rgb <0.1, 0.5 + rand(R1) * 0.4, 0.1> } }
  #end
#end
union { Branch(4, 1.6, 0.2, 0) }
#debug concat("leaves: ", str(Leaves, 0, 0), "\n")
#macro Sierpinski(P, S, L)
  #if (L = 0) box { P - S / 2, P + S / 2 }
  #else
    #local D = array[4] { <1,1,1>, <-1,-1,1>, <-1,1,-1>, <1,-1,-1> }
    #for (I, 0, 3) Sierpinski(P + D[I] * S / 4, S / 2, L - 1) #end
  #end
#end
union { Sierpinski(<3, 1, 0>, 1.6, 4) pigment { rgb <0.8, 0.7, 0.2> } finish { phong 0.6 } }
plane { y, 0 pigment { hexagon rgb 0.9, rgb 0.6, rgb <0.6, 0.7, 0.8> scale 0.5 } }
camera { location <1, 3, -8> look_at <1, 2, 0> angle 50 }
light_source { <10, 20, -20> White }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.8,0.9,1>] [1 rgb <0.2,0.4,0.9>] } } }
