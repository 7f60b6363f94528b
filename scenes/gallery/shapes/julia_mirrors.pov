// A Julia set that mirrors itself after 40 steps of its map: orbits blow up the last digits of where
// a reflected ray begins.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-2, 1.5, 1.5> up y right 4/3 * x angle 60 look_at <0.5, -0.4, -0.4> }
light_source { <0, 5, 2> rgb 1 }
background { rgb <0.8, 0.9, 1> }
julia_fractal {
  <-0.08, 0, -0.83, -0.025>
  quaternion sqr
  max_iteration 40
  precision 40
  slice <0, 0, 0, 1>, 0.1
  pigment { rgb <1, 0.9, 0.7> }
  finish { reflection 0.3 }
}
