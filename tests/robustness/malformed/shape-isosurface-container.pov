#version 3.7;
isosurface {
  function { x * x + y * y + z * z - 1 }
  contained_by { cylinder { -y, y, 1 } }
}
