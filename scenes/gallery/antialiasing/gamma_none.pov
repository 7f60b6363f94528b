#version 3.6;
// A scene of the time before gamma handling: contrast is judged on the raw values.
camera { location <0, 1.5, -5> right 4/3*x angle 50 look_at <0, 0.4, 0> }
light_source { <4, 6, -5>, rgb 1 }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.05, 0.1, 0.15> scale 0.4 } }
sphere { <-0.8, 0.6, 0>, 0.6 pigment { rgb <0.1, 0.02, 0.02> } finish { reflection 0.3 phong 1 } }
torus { 0.5, 0.2 rotate x*60 translate <0.8, 0.6, 0.2> pigment { rgb <0.2, 0.7, 0.3> } }
