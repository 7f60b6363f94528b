// 100,000 trace() calls on a CSG of 1,000 parts; each hit becomes part of a sum, some a small sphere.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 9, -16> look_at 0 }
light_source { <10, 20, -15> rgb 1 }

#declare Numbers = seed(7);
#declare Rock = difference {
  box { <-5, -1, -5>, <5, 1, 5> }
  #for (Index, 0, 998)
    sphere { <10 * rand(Numbers) - 5, 1.2 * rand(Numbers), 10 * rand(Numbers) - 5>, 0.05 + 0.3 * rand(Numbers) }
  #end
}

#declare Hits = 0;
#declare Sum = <0, 0, 0>;
#declare Normal = <0, 0, 0>;
#for (Index, 1, 100000)
  #declare Start = <11 * rand(Numbers) - 5.5, 5, 11 * rand(Numbers) - 5.5>;
  #declare Place = trace(Rock, Start, <0.3 * rand(Numbers), -1, 0>, Normal);
  #if (vlength(Normal) > 0)
    #declare Hits = Hits + 1;
    #declare Sum = Sum + Normal;
    #if (mod(Index, 200) = 0)
      sphere { Place + 0.05 * Normal, 0.05 pigment { rgb <1, 0.3, 0.1> } }
    #end
  #end
#end
#debug concat("hits ", str(Hits, 0, 0), ", sum of normals ", vstr(3, Sum, ", ", 0, 4), "\n")
object { Rock pigment { rgb <0.6, 0.6, 0.55> } }
