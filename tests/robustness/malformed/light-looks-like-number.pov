#version 3.7;
light_source {
  <10, 10, -10>, 1
  looks_like { 3 }
}
