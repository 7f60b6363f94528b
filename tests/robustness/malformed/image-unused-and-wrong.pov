#version 3.7;
global_settings { assumed_gamma 1 }
plane { z, 3
} #declare Unused = pigment { image_map { png "text.png" } };
 plane { y, 0
}
