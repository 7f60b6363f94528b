#version 3.7;
text {
  "Dürer", 1, 0
}
