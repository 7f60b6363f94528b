// With antialiasing: means of samples that lie amid two codes of the picture, in the old gamma.
camera { orthographic location -z look_at 0 right 16 * x up 12 * y }
plane {
  z, 0
  pigment {
    checker
    pigment { checker rgb <188, 225, 6> / 255 rgb <154, 191, 228> / 255 scale 0.365 translate z * 0.1 }
    pigment { checker rgb <9, 46, 83> / 255 rgb <0, 37, 74> / 255 scale 0.365 translate z * 0.1 }
    scale 0.73
    translate z * 0.1
  }
  finish { ambient 1 diffuse 0 }
}
