#version 3.7;
global_settings { assumed_gamma 1 }
#declare f_h = function(x, z) { 0.4 * sin(3 * x) * cos(2 * z) + 0.1 * pow(x, 2) - 0.05 * z }
#declare Nx = 20; #declare Nz = 20;
#declare V = array[Nx + 1][Nz + 1];
#for (I, 0, Nx) #for (J, 0, Nz) #declare X = -2 + 4 * I / Nx; #declare Z = -2 + 4 * J / Nz; #declare V[I][J] = <X, f_h(X, Z), Z>; #end #end
#fopen Out "mesh.inc" write
#write (Out, "mesh {\n")
#for (I, 0, Nx - 1) #for (J, 0, Nz - 1)
#write (Out, "triangle {", V[I][J], ",", V[I + 1][J], ",", V[I + 1][J + 1], "}\n")
#write (Out, "triangle {", V[I][J], ",", V[I + 1][J + 1], ",", V[I][J + 1], "}\n")
#end #end
#write (Out, "}\n")
#fclose Out
object { #include "mesh.inc" pigment { gradient y color_map { [0 rgb <0,0,1>] [0.5 rgb <0,1,0>] [1 rgb <1,0,0>] } scale 1.2 translate -0.5 * y } finish { phong 0.4 } }
#declare S = spline { cubic_spline -1, <-2, 1, -2>, 0, <-1.5, 0.8, -1>, 1, <0, 1.4, 0>, 2, <1.5, 0.9, 1>, 3, <2, 1, 2> }
#for (T, 0, 2, 0.05) sphere { S(T), 0.07 pigment { rgb <T / 2, 1 - T / 2, 0.5> } } #end
#declare Ball = sphere { 0, 1 } #declare Hit = trace(Ball, <0, 5, 0>, -y); #debug concat(vstr(3, Hit, ",", 0, 4), "\n")
camera { location <3, 3.5, -4> look_at <0, 0.2, 0> angle 45 }
light_source { <5, 10, -5>, rgb 1 }
