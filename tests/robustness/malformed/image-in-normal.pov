#version 3.7;
global_settings { assumed_gamma 1 }
plane { z, 3
  normal { bump_map { png "text.png" bump_size 2 } }
}
