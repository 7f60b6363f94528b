// An object flag uv_mapping reaches all members, those with a texture of their own too; their
// textures move with the whole all the same. Blobs move the textures of their parts, meshes do not.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -8*z right 8*x up 6*y look_at 0 }
light_source { <-7,9,-11> rgb 1 }
#declare C = texture { pigment { checker rgb 1 rgb <1,0,0> scale .3 } };
#declare C1 = texture { pigment { checker rgb 1 rgb <1,0,0> scale .1 } };
#macro S() sphere { 0, .9 rotate 30 texture { C } } #end
union { sphere { 0,.9 uv_mapping } sphere { 0.2*x, .9 } pigment { checker rgb 1 rgb <0,0,1> scale .1 } translate <-3,2,0> }
// mesh/blob own textures
union { mesh { triangle { <-.8,-.8,0>,<.8,-.8,0>,<0,.8,0> uv_vectors <0,0>,<1,0>,<0,1> texture { C1 } } } sphere { .5*x,.3 texture { C1 } } uv_mapping pigment { checker rgb 1 rgb <0,0,1> scale .1 } rotate 20*z translate <-1,2,0> }
union { blob { threshold .3 sphere { 0, 1, 1 texture { C } } sphere { .5*x, .7, 1 } texture { C1 }} sphere { .5*y,.3 texture { C1 } } uv_mapping pigment { checker rgb 1 rgb <0,0,1> scale .1 } rotate 20*z translate <1,2,0> }
#declare B = blob { threshold .3 sphere { 0, 1, 1 texture { C } } sphere { .5*x, .7, 1 texture { C1} } };
object { B uv_mapping pigment { checker rgb 1 rgb <0,0,1> scale .1 } rotate 20*z translate <3.05,2.07,0> }
#declare U = union { S() sphere { .5*x, .5 texture { C1 } } sphere { -.5*x, .5 } };
object { U uv_mapping pigment { checker rgb 1 rgb <0,0,1> scale .1 } rotate 20*z translate <-3.05,0.07,0> }
#declare V = union { S() sphere { .5*x, .5 texture { C1 } } sphere { -.5*x, .5 } uv_mapping pigment { checker rgb 1 rgb <0,0,1> scale .1 } };
object { V rotate 20*z translate <-1.05,.07,0> }
#declare V = union { object { V } scale 1 translate 0.033*x };
object { V rotate 20*z translate <.95,.07,0> }
union { object { V translate 0.1*x } rotate 20*z translate <2.95,.07,0> }
object { V rotate 10*z texture { C } translate <-3.05,-2.07,0> }
object { U uv_mapping rotate 20*z texture { C } translate <-1.05,-2.07,0> }
union { S() sphere { -.3*x, .9 } uv_mapping interior_texture { C1 } texture { C } clipped_by { plane { z, -.3 } } translate <1.05,-2,0> }
union { union { S() scale .98 } sphere { -.3*x, .9 uv_mapping pigment { checker rgb 1 rgb <0,0,1> scale .1 } } texture { C } translate <3.05,-2,0> }
