#version 3.7;
camera {
  position -5 * z
}
