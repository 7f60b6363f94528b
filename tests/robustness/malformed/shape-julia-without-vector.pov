#version 3.7;
julia_fractal {
  max_iteration 5
}
