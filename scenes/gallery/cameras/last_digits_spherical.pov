// Planes in the jumps of their patterns show the last digit of every ray's direction.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { spherical location <2.3, 0.61, -4.25> look_at 0 }
#default { finish { ambient 1 diffuse 0 } }
plane { z, 1 pigment { gradient z } }
plane { y, 0 pigment { checker rgb <0.9, 0.4, 0.2> rgb <0.2, 0.5, 0.9> scale 0.7 } }
mesh {
  triangle { <-3, 0, 0>, <3, 0, 0>, <0, 3, 0> }
  texture { pigment { square } }
  scale 1.4
}
