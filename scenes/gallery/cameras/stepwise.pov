#version 3.7;
// Before 3.5 every modifier acts where it stands: look_at before the last location, transforms
// between, and a declared camera changed by new modifiers.
#include "surroundings.inc"

#version 3.1;
#declare First = camera {
  location <0, 1, -5>
  look_at <0.5, 0, 2>
  angle 60
  rotate y * 15
  right x * 4/3
}
camera {
  First
  translate <0.5, 0, 0>
  look_at <0, 0.3, 3>
  location <0.2, 0.8, -6>
  direction 1.2 * z
  rotate <2, -4, 3>
}
#version 3.7;
