// A smooth triangle of a mesh whose normal has two equal components in single, not in double precision.
#version 3.6;
camera{direction -2.836*z location 0 right 1.333333333*x up y}
light_source{<4000,4000,9999> rgb 1}
#default{finish{ambient .2 diffuse .6 phong .5 phong_size 40 specular .2}}
#declare P=<-0.97686930512470849,3.58236703988685434,-45.35228072790249598>;
#declare Q=<-1.28540382110173890,4.62455968910934345,-45.94204724101397375>;
mesh2{vertex_vectors{4,P+x,P+y,Q,Q+<.2,.5,.1>}
normal_vectors{4,<0.1,0.2,1>,<-0.1,0.5,0.7>,<0.4,0.1,0.8>,<0,0,1>}
face_indices{1,<0,1,2>} pigment{rgb 1}}
