#version 3.7;
sphere { 0, 1
  pigment { rgb 1 }
  normal { bumps
    no_bump_scale on
  }
}
