// A solid whose own texture stops light is remembered as what stopped it last, clear members and all: its
// clear part filters once more (docs/decisions/0069).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <-1.12, 3.01, -5.66> look_at <-0.4, 0, -0.6> angle 48 }
light_source { <1.9, 9, -3.8> rgb 1 }
plane { y, -1 pigment { checker rgb 1 rgb 0.5 } }
difference {
  union {
    box { <-0.7, -0.7, -0.7>, <0.7, -0.2, 0.7>
      pigment { rgbf <0.74, 0.74, 0.78, 0.59> } interior { ior 1.48 } }
    cylinder { -0.3*y, 0.7*y, 0.45 }
    pigment { rgbf <0.62, 0.59, 0.71, 0.38> }
  }
  union {
    sphere { 0.7*y, 0.4 }
    torus { 0.45, 0.1 pigment { rgb <0.81, 0.56, 0.59> } }
  }
  pigment { rgb <0.2, 0.9, 0.9> }
  rotate <-40, 1, -46> translate <-0.9, 0.89, -1>
}
