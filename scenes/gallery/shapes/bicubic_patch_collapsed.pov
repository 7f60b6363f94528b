// Patches of which an edge has shrunk to a point, split along one direction and along both: the
// normals there are of tangents that only rounding leaves, different at each piece.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.3, 0.5, -6> look_at 0 angle 40 }
light_source { <-7, 9, -11> rgb 1 }
background { rgb <0.1, 0.2, 0.3> }
#macro Patch(Steps_U, Steps_V, Flatness)
  bicubic_patch {
    type 1 flatness Flatness u_steps Steps_U v_steps Steps_V
    <-0.9, -0.9, 0.42>, <-0.9, -0.3, -0.23>, <-0.9, 0.3, 0.36>, <-0.9, 0.9, 0.24>,
    <-0.3, -0.9, 0.49>, <-0.3, -0.3, -0.52>, <-0.3, 0.3, -0.48>, <-0.9, 0.9, 0.24>,
    <0.3, -0.9, -0.24>, <0.3, -0.3, -0.47>, <0.3, 0.3, -0.4>, <-0.9, 0.9, 0.24>,
    <0.9, -0.9, -0.32>, <0.9, -0.3, -0.16>, <0.9, 0.3, -0.49>, <-0.9, 0.9, 0.24>
    pigment { rgb <0.9, 0.8, 0.6> } finish { phong 0.5 }
  }
#end
object { Patch(4, 0, 0) translate <-1.2, 1, 0> }
object { Patch(3, 3, 0) translate <1.3, 1, 0> }
object { Patch(5, 1, 0.05) scale <0.8, 0.9, 1> rotate <20, 30, 10> translate <-1.2, -1, 0> }
object { Patch(2, 5, 0.01) rotate 180*z translate <1.2, -0.9, 0> }
