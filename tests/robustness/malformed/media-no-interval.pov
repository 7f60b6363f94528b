#version 3.7;
sphere {
  0, 1
  interior {
    media { intervals -1 }
    ior 1.5
  }
}
