// 1,500 differences of four parts each: what a ray pays for composites.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 14, -22> look_at <0, -1, 0> }
light_source { <20, 40, -30> rgb 1 }
#for (Layer, 0, 14)
  #for (Row, 0, 9)
    #for (Column, 0, 9)
      difference {
        box { -0.45, 0.45 }
        sphere { 0, 0.55 }
        cylinder { -y, y, 0.3 }
        cylinder { -x, x, 0.2 }
        pigment { rgb <0.3 + Column * 0.07, 0.3 + Row * 0.07, 0.9 - Layer * 0.05> }
        finish { phong 0.4 }
        rotate <7 * Layer, 11 * Row, 5 * Column>
        translate <1.5 * (Column - 4.5), 0.9 * (Layer - 9), 1.5 * (Row - 4.5)>
      }
    #end
  #end
#end
