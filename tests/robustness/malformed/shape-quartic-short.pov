#version 3.7;
quartic {
  <1, 2, 3, 4, 5>
}
