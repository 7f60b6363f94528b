// Meshes without inside_vector in CSG: of what lies behind the hit found last, only hits are there whose
// boxes start before it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -5*z look_at 0 angle 55 }
light_source { <3, 5, -6>, 1 }
#macro Ball(N)
  mesh {
    #for (J, 0, N - 1)
      #for (I, 0, 2*N - 1)
        #local A = <sin(pi*J/N)*cos(pi*I/N), cos(pi*J/N), sin(pi*J/N)*sin(pi*I/N)>;
        #local B = <sin(pi*(J + 1)/N)*cos(pi*I/N), cos(pi*(J + 1)/N), sin(pi*(J + 1)/N)*sin(pi*I/N)>;
        #local C = <sin(pi*J/N)*cos(pi*(I + 1)/N), cos(pi*J/N), sin(pi*J/N)*sin(pi*(I + 1)/N)>;
        #local D = <sin(pi*(J + 1)/N)*cos(pi*(I + 1)/N), cos(pi*(J + 1)/N), sin(pi*(J + 1)/N)*sin(pi*(I + 1)/N)>;
        triangle { A, B, C }
        triangle { B, C, D }
      #end
    #end
  }
#end
#macro Row(M, Y)
  object { M clipped_by { plane { <1, -1, 2>, 0 inverse } } scale 0.6 pigment { rgb <1, 0.5, 0.2> } translate <-1.9, Y, 0> }
  difference { object { M } sphere { <0, 0.5, -1>, 1 } scale 0.6 pigment { rgb <1, 0.8, 0.2> } translate <-0.65, Y, 0> }
  intersection { object { M } box { -0.7, 0.7 rotate 20 } scale 0.6 pigment { rgb <0.5, 1, 0.2> } translate <0.65, Y, 0> }
  difference { object { M rotate <30, 20, 0> } cylinder { -2*y, 2*y, 0.6 rotate 60*x } scale 0.6 pigment { rgb <0.5, 0.6, 1> } translate <1.9, Y, 0> }
#end
Row(Ball(16), 0.75)
Row(Ball(2), -0.75)
