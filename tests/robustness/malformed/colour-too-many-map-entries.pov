#version 3.7;
#declare P = pigment {
  gradient x
  color_map {
    #for (I, 0, 300)
      [I / 300 rgb <I / 300, mod(I, 7), mod(I, 3)>]
    #end
  }
}
