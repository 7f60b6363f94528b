#version 3.7;
camera {
  perspective
  location -5 * z
  angle 190
}
