#version 3.7;
#declare Two = union { sphere { 0, 1 } box { -1, 1 } }
union {
  Two
  sphere { x, 1 }
}
