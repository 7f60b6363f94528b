// A cube with bars cut out of it whose faces lie in those of the others, in glass: on every way through
// it surfaces coincide, and the solids' own tests settle which of them is there.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }
camera { location <1, 2.5, -5> look_at <0.3, 0, 0> angle 36 }
light_source { <-5, 10, -8> rgb 1 }
plane { y, -1.8 pigment { hexagon rgb 1 rgb <0.8, 0.2, 0.2> rgb <0.2, 0.2, 0.8> scale 0.5 } }

difference {
  box { -1, 1 }
  #for (Axis, 0, 2)
    #for (X, -3, 3, 3)
      #for (Y, -3, 3, 3)
        box {
          <X - 0.5, Y - 0.5, -10>/4.5, <X + 0.5, Y + 0.5, 10>/4.5
          rotate 90*(Axis = 1)*x
          rotate 90*(Axis = 2)*y
        }
      #end
    #end
  #end
  box { <-2, -1/3, -1/3>, <2, 1/3, 1/3> }
  box { <-1/3, -2, -1/3>, <1/3, 2, 1/3> }
  box { <-1/3, -1/3, -2>, <1/3, 1/3, 2> }
  pigment { rgbt <0.8, 0.9, 1, 0.6> }
  finish { reflection 0.1 }
  interior { ior 1.2 }
  rotate <-20, 40, 10>
  translate 0.4*x
}
