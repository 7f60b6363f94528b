#version 3.7;
#declare Red = pigment { rgb x }
sphere {
  0, 1
  finish { Red }
}
