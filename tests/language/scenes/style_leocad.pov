// brick model
#version 3.7;
global_settings { assumed_gamma 1.0 }
background { color rgb <1, 1, 1> }
#declare lg_quality = 2;
#ifndef (lg_quality) #declare lg_quality = 3; #end
#declare lc_Red = texture { pigment { rgb <0.77,0.0,0.15> } finish { ambient 0.1 phong 0.5 phong_size 40 reflection 0.04 } }
#declare lc_TransBlue = texture { pigment { rgb <0,0.13,0.63> filter 0.85 } finish { ambient 0.1 phong 0.5 reflection 0.04 } }
#declare stud = union { cylinder { <0,0,0>,<0,0,4>,6 } torus { 6, 0.3 rotate x*90 translate z*3.7 } }
#declare brick_3001 = union {
  difference { box { <-40,-20,0>, <40,20,24> } box { <-36,-16,-0.1>, <36,16,20> } }
  #declare X = -30;
  #while (X <= 30)
    #declare Y = -10;
    #while (Y <= 10)
      object { stud translate <X, Y, 24> }
      #declare Y = Y + 20;
    #end
    #declare X = X + 20;
  #end
  mesh2 {
    vertex_vectors { 4, <-40,-20.05,2>, <40,-20.05,2>, <40,-20.05,6>, <-40,-20.05,6> }
    face_indices { 2, <0,1,2>, <0,2,3> }
  }
}
camera { perspective right -image_width / image_height * x sky<0,0,1> location <-120, -160, 120> look_at <0, 0, 10> angle 38 }
light_source { <-200, -100, 300> rgb <1,1,1> area_light 40*x, 40*y, 3, 3 adaptive 1 jitter }
light_source { <200,-300,200> rgb 0.4 shadowless }
object { brick_3001 matrix <1,0,0, 0,1,0, 0,0,1, 0,0,0> texture { lc_Red } }
object { brick_3001 matrix <0,1,0, -1,0,0, 0,0,1, 10,0,24> texture { lc_TransBlue } interior { ior 1.25 } }
plane { z, 0 pigment { rgb 0.8 } finish { ambient 0.1 diffuse 0.7 } }
