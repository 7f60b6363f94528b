// 5,000 copies of a declared union of 400 primitives, each with a transform of its own: what a copy costs.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 60, -110> look_at <0, -8, 0> angle 50 }
light_source { <80, 120, -60> rgb 1 }

#declare Turns = seed(1);
#declare Bush = union {
  #for (Index, 0, 199)
    sphere {
      <2 * rand(Turns) - 1, 1 + rand(Turns), 2 * rand(Turns) - 1> * 0.5, 0.04
      pigment { rgb <0.2, 0.5 + 0.4 * rand(Turns), 0.1> }
    }
    cone {
      <0, 0, 0>, 0.02, <2 * rand(Turns) - 1, 1 + rand(Turns), 2 * rand(Turns) - 1> * 0.5, 0.005
      pigment { rgb <0.4, 0.3, 0.15> }
    }
  #end
}

#for (Row, 0, 49)
  #for (Column, 0, 99)
    object {
      Bush
      scale <0.8 + 0.6 * rand(Turns), 1 + rand(Turns), 0.8 + 0.6 * rand(Turns)>
      rotate 360 * rand(Turns) * y
      translate <Column - 49.5 + 0.3 * rand(Turns), 0, 1.6 * (Row - 24.5)>
    }
  #end
#end
plane { y, 0 pigment { rgb <0.5, 0.45, 0.35> } }
