// Profiles of many segments: prisms, straight and conic, with holes, and lathes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -7> look_at <0, 0, 0.4> angle 50 }
light_source { <-6, 8, -10>, 1 }
background { rgb <0.1, 0.15, 0.25> }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.3, 0.3, 0.5> } }
#declare Gold = texture { pigment { rgb <0.9, 0.7, 0.3> } finish { phong 0.6 } }
#macro Wheel(Teeth, Inner, Outer)
  #for (I, 0, Teeth)
    <cos(2 * pi * I / Teeth), sin(2 * pi * I / Teeth)> * (mod(I, 2) = 0 ? Inner : Outer)
  #end
#end
prism {
  linear_spline linear_sweep -0.5, 0, 82
  Wheel(60, 1, 1.2)
  Wheel(20, 0.5, 0.6)
  texture { Gold } translate <-2.6, 0, 0>
}
prism {
  linear_spline conic_sweep 0.4, 1, 61
  Wheel(60, 1, 1.15)
  texture { Gold } rotate 180 * x translate <0, 0.5, 0>
}
prism {
  cubic_spline linear_sweep -0.3, 0.3, 45
  #for (I, -1, 43) <cos(2 * pi * I / 42), sin(2 * pi * I / 42)> * (1 + 0.15 * cos(pi * I)) #end
  texture { Gold } rotate <40, 0, 20> translate <2.6, 0, 0>
}
lathe {
  linear_spline 60
  #for (I, 0, 59) <0.5 + 0.2 * sin(I * 0.4), I / 30> #end
  texture { Gold } translate <-1.3, -1, 2.4>
}
difference {
  lathe {
    cubic_spline 40
    #for (I, -1, 38) <0.6 + 0.2 * sin(I * 0.5), I / 20> #end
  }
  box { <0, 0.5, -2>, <2, 1.2, 2> }
  texture { Gold } translate <1.5, -1, 2.4>
}
