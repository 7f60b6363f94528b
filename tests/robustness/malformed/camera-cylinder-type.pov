#version 3.7;
camera {
  cylinder 7
  location -5 * z
}
