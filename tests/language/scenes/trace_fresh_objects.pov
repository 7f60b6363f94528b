// trace() at thousands of objects that nobody else has: moved meshes, and CSG with a text. What is dear to
// compile must be compiled once, and nothing is kept for good.
#version 3.7;
#declare R = seed(1);
#declare Mesh = mesh {
  #for (I, 0, 3200)
    triangle {
      <rand(R), rand(R), rand(R)>, <rand(R), rand(R), rand(R)>, <rand(R), rand(R), rand(R)>
    }
  #end
}
#declare Word = text { ttf "cyrvetic.ttf" "word" 0.3, 0 }
#declare Sum = 0;
#declare Met = 0;
#for (I, 0, 2000)
  #local Moved = object { Mesh translate I / 10000 * x };
  #local Part = intersection { object { Word } sphere { <I / 1000, .3, 0>, .1 } };
  #local Normal = <0, 0, 0>;
  #declare Sum = Sum + trace(Moved, <.5, .5, -3>, z, Normal).z;
  #local Normal = <0, 0, 0>;
  #local Point = trace(Part, <I / 1000, .3, -3>, z, Normal);
  #if (vlength(Normal) != 0) #declare Met = Met + 1; #end
#end
#debug concat("depths ", str(Sum, 0, 6), ", met ", str(Met, 0, 0), "\n")
camera { location -5*z look_at 0 }
sphere { 0, 1 }
