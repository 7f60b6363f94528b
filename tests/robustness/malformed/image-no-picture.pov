#version 3.7;
global_settings { assumed_gamma 1 }
plane { z, 3
  pigment { image_map { png "text.png" } }
}
