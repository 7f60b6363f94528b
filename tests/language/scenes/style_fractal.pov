#version 3.6;
global_settings { max_trace_level 8 }
#include "colors.inc"
#declare Depth = 5;
#macro Menger(L, P, S)
 #if (L <= 0)
  box { P - S/2, P + S/2 }
 #else
  #local i = -1;
  #while (i <= 1)
   #local j = -1;
   #while (j <= 1)
    #local k = -1;
    #while (k <= 1)
     #if ((abs(i) + abs(j) + abs(k)) > 1)
       Menger(L - 1, P + <i, j, k> * S / 3, S / 3)
     #end
     #local k = k + 1;
    #end
    #local j = j + 1;
   #end
   #local i = i + 1;
  #end
 #end
#end
#declare Sponge = union { Menger(2, 0, 2) }
object { Sponge rotate <20, 30, 0> pigment { color rgb <0.8, 0.6, 0.3> } finish { specular 0.3 } }
#declare Koch = array[4096];
#declare KN = 0;
#macro KochLine(A, B, L)
 #if (L = 0)
   #declare Koch[KN] = A; #declare KN = KN + 1;
 #else
   #local D = (B - A) / 3; #local P1 = A + D; #local P2 = P1 + vaxis_rotate(D, z, 60); #local P3 = A + 2 * D;
   KochLine(A, P1, L-1) KochLine(P1, P2, L-1) KochLine(P2, P3, L-1) KochLine(P3, B, L-1)
 #end
#end
KochLine(<-2.5, 1.6, 0>, <2.5, 1.6, 0>, 4)
#declare I = 1;
union { #while (I < KN) cylinder { Koch[I-1], Koch[I], 0.02 } #declare I = I + 1; #end pigment { Red } }
#debug concat("points ", str(KN, 0, 0), " extent ", vstr(3, max_extent(Sponge), " ", 0, 4), "\n")
camera { location <0, 0.5, -7> look_at <0, 0.5, 0> }
light_source { <10, 10, -10> White }
light_source { <-10, 4, -10> rgb 0.3 }
background { SkyBlue }
