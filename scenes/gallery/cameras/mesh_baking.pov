#version 3.7;
// Distribution 3 bakes a texture: the pixel is the place on the uv square; smooth normals.
#include "surroundings.inc"

// A sphere of triangles without its poles, with its seam at the back.
#declare Columns = 24;
#declare Rows = 12;
#macro On_Sphere(X, Y) vrotate(vrotate(-y, x * (12 + 156 * Y/Rows)), -y * 360 * X/Columns) #end
#declare Ball = mesh2 {
  vertex_vectors {
    (Columns + 1) * (Rows + 1)
    #for (Y, 0, Rows) #for (X, 0, Columns) , On_Sphere(X, Y) #end #end
  }
  normal_vectors {
    (Columns + 1) * (Rows + 1)
    #for (Y, 0, Rows) #for (X, 0, Columns) , On_Sphere(X, Y) #end #end
  }
  uv_vectors {
    (Columns + 1) * (Rows + 1)
    #for (Y, 0, Rows) #for (X, 0, Columns) , <0.013 + 0.97*X/Columns, 0.017 + 0.96*Y/Rows> #end #end
  }
  face_indices {
    2 * Columns * Rows
    #for (Y, 0, Rows - 1)
      #for (X, 0, Columns - 1)
        #local I = Y * (Columns + 1) + X;
        , <I, I + 1, I + Columns + 1>, <I + 1, I + Columns + 2, I + Columns + 1>
      #end
    #end
  }
}
object { Ball scale <1, 1.3, 1> pigment { checker rgb 1, rgb <0.4, 0.6, 0.9> scale 0.37 translate 0.11 } translate <0, 0.4, -0.5> }
camera {
  mesh_camera { 1 3 mesh { Ball scale <1, 1.3, 1> translate <0, 0.4, -0.5> } smooth }
  location 0.2 * z
  direction -z
}
