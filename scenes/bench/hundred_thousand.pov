// 100,000 spheres and cylinders: building and tracing a big world.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 60, -90> look_at <0, -10, 0> }
light_source { <60, 120, -80> rgb 1 }
#declare Numbers = seed(3);
#for (Index, 1, 50000)
  #declare Place = <120 * rand(Numbers) - 60, 30 * rand(Numbers) - 20, 120 * rand(Numbers) - 60>;
  sphere { Place, 0.15 + 0.3 * rand(Numbers) pigment { rgb <rand(Numbers), 0.5, 0.3> } }
  cylinder {
    Place, Place + <2 * rand(Numbers) - 1, 2 * rand(Numbers), 2 * rand(Numbers) - 1>, 0.08
    pigment { rgb <0.3, 0.5, rand(Numbers)> }
  }
#end
