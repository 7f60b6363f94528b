// Three area lights over 125 balls and boxes: soft shadows, many shadow rays per point.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 7, -13> look_at <0, 0.5, 0> }
#macro Lamp(Place, Color)
  light_source {
    Place, Color
    area_light 3 * x, 3 * z, 7, 7
    adaptive 1 jitter circular orient
  }
#end
Lamp(<8, 10, -6>, rgb 0.5)
Lamp(<-9, 8, -4>, rgb <0.3, 0.25, 0.2>)
Lamp(<1, 12, 6>, rgb <0.1, 0.15, 0.25>)
plane { y, 0 pigment { checker rgb 0.85, rgb 0.6 scale 2 } }
#for (Column, -2, 2)
  #for (Row, -2, 2)
    #for (Layer, 0, 4)
      #if (mod(Column + Row + Layer + 10, 2) = 0)
        sphere { <2.2 * Column, 0.4 + Layer, 2.2 * Row>, 0.4 pigment { rgb <0.9, 0.5, 0.3> } }
      #else
        box {
          -0.3, 0.3
          rotate <20 * Layer, 30 * Column, 0>
          translate <2.2 * Column, 0.4 + Layer, 2.2 * Row>
          pigment { rgb <0.3, 0.6, 0.8> }
          finish { specular 0.4 }
        }
      #end
    #end
  #end
#end
