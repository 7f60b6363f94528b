// Triangles of a ten-thousandth of a unit, a hundred thousand units from the origin: vertices are
// single precision, so they are made near the origin and moved.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Far = <1e5, 2e4, -5e4>;
camera { location Far + <0.001, 0.002, -0.004> look_at Far + <0, 0, 0> angle 35 }
light_source { Far + <-6, 8, -10>, 1 }
background { rgb <0.1, 0.15, 0.25> }
#declare Wave = function(x, z) { 0.0003*sin(x*4000)*cos(z*3000) }
mesh {
  #for (I, -8, 7)
    #for (J, -8, 7)
      #local A = <I, 0, J>*1e-4; #local B = A + <1e-4, 0, 0>; #local C = A + <0, 0, 1e-4>; #local D = A + <1e-4, 0, 1e-4>;
      triangle { A + y*Wave(A.x, A.z), B + y*Wave(B.x, B.z), C + y*Wave(C.x, C.z) }
      triangle { D + y*Wave(D.x, D.z), B + y*Wave(B.x, B.z), C + y*Wave(C.x, C.z) }
    #end
  #end
  pigment { checker rgb 1, rgb <0.2, 0.4, 0.8> scale 2.5e-4 }
  translate Far
}
sphere { Far + 0.0005*y, 0.0004 pigment { rgb <0.9, 0.6, 0.3> } }
