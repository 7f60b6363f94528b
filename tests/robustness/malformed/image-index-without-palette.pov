#version 3.7;
global_settings { assumed_gamma 1 }
plane { z, 3
  pigment { image_map { pgm "greys.pgm"
   filter 0, 0.5 } }
}
