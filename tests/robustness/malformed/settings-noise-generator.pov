#version 3.7;
global_settings {
  noise_generator 5
}
