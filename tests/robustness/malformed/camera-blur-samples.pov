#version 3.7;
camera {
  location -5*z aperture 0.3
  blur_samples 4, 2
  look_at 0
}
