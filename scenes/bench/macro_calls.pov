// 200,000 calls of a macro that makes a sphere, in nested #for loops: what parsing a loop costs.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 40, -70> look_at <0, -4, 0> }
light_source { <30, 80, -40> rgb 1 }

#macro Ball(Column, Row, Layer)
  sphere {
    <Column - 50, Layer * 0.9 - 9, Row - 50>, 0.25 + 0.1 * sin(Column * 0.3) * cos(Row * 0.2)
    pigment { rgb <Column / 100, Row / 100, Layer / 20> }
  }
#end

#for (Layer, 0, 19)
  #for (Row, 0, 99)
    #for (Column, 0, 99)
      Ball(Column, Row, Layer)
    #end
  #end
#end
