// Places on the seams of the texture belong to the first face, on upright, level and sloping ones.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Columns = 8;
#declare Rows = 10;
#declare Sheet = mesh2 {
  vertex_vectors {
    (Columns + 1) * (Rows + 1),
    #for (J, 0, Rows) #for (I, 0, Columns) <I, J, 0.3 * sin(I * 2 + J * 3)>, #end #end
  }
  uv_vectors {
    (Columns + 1) * (Rows + 1),
    #for (J, 0, Rows) #for (I, 0, Columns) <I / Columns, 1 - (J * 12 - 0.5) / 120>, #end #end
  }
  #macro Faces()
    Columns * Rows * 2,
    #for (J, 0, Rows - 1)
      #for (I, 0, Columns - 1)
        #local K = J * (Columns + 1) + I;
        <K, K + 1, K + Columns + 1>, <K + 1, K + Columns + 2, K + Columns + 1>,
      #end
    #end
  #end
  face_indices { Faces() }
  uv_indices { Faces() }
}
camera { mesh_camera { 1 3 mesh { Sheet } } location 0.01 * z }
sphere { 0, 100 inverse pigment { cells scale 5 } finish { ambient 1 diffuse 0 } }
