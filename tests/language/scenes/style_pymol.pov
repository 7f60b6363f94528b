camera {direction<0.0,0.0,  -3.732>
 location <0.0 , 0.0 , 0.0>
 right 1.333*x up y
 }
#default { texture { pigment{ color rgb <1,1,1> } finish { ambient 0.140 diffuse 0.640 phong 0.200 phong_size 30.00 specular 0.10 roughness 0.02 } } }
light_source{<4000.0001,4000.0001,9909.7070>  rgb<1.0,1.0,1.0>}
plane{z , -190.0000 
 pigment{color rgb<0.0,0.0,0.0>}
 finish{phong 0 specular 0 diffuse 0 ambient 1.0}}
sphere{<-2.3,1.0,-30.0>, 1.8
pigment{color rgb<0.2000,1.0000,0.2000>}}
sphere{<0.3,-1.0,-31.0>, 1.5 pigment{color rgb<1,0.3,0.3>}}
cylinder{<-2.3,1.0,-30.0>,<0.3,-1.0,-31.0>,0.25
open
pigment{color rgb<0.9,0.9,0.9>}}
#declare mesh_1 = mesh2 {
vertex_vectors{4,
<1,1,-28>,<3,1,-28>,<3,3,-29>,<1,3,-29>}
normal_vectors{4, <0,0,1>,<0.3,0,1>,<0,0.3,1>,<0.2,0.2,1>}
texture_list{3,
texture{pigment{color rgb<1,0,0>}}
,texture{pigment{color rgb<0,1,0>}}
,texture{pigment{color rgb<0,0,1>}}
}
face_indices{2,
<0,1,2>,0,1,2,
<0,2,3>,0,2,1}
}
object{mesh_1}
smooth_triangle{<-1,-3,-28>,<0,0,1>,<1,-3,-28>,<0.2,0,1>,<0,-1,-29>,<0,0.2,1>
pigment{color rgbt<1,1,0,0.3>}}
