#version 3.7;
// Before 3.5 orthographic scales the view where the word stands, by what was given so far.
#include "surroundings.inc"

#version 3.1;
camera {
  location <1, 1.5, -7>
  look_at <0, 0.5, 1>
  orthographic
  right x * 8
  angle 50
  rotate x * -3
}
#version 3.7;
