#version 3.7;
mesh {
  triangle { 0, x, y texture { Gold } }
}
