#version 3.7;
isosurface {
  threshold 0
  contained_by { box { -1, 1 } }
}
