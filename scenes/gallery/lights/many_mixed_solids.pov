// Many solids half clear, half opaque: which one stopped the light last decides no pixel (docs/decisions/0069).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 30, -40> look_at 0 angle 60 }
light_source { <50, 90, -90> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0.3 } }
#for (Row, -10, 9)
  #for (Column, -15, 14)
    difference {
      sphere { 0, 0.4 pigment { rgbt <1, 0.5, 0.5, 0.6> } }
      box { <0, -1, -1>, <1, 1, 1> pigment { rgb 1 } }
      pigment { rgb 1 }
      translate <1.2 * Column, 1, 1.2 * Row>
    }
  #end
#end
