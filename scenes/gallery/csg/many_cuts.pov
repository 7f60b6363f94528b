// A box with 2000 spherical cuts.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -5> look_at 0 angle 45 }
light_source { <-6, 8, -10>, 1 }
background { rgb <0.1, 0.15, 0.25> }
#declare Random = seed(7);
difference {
  box { <-1.5, -0.5, -1.5>, <1.5, 0.5, 1.5> }
  #for (I, 1, 2000)
    sphere { <rand(Random)*3 - 1.5, rand(Random) - 0.5, rand(Random)*3 - 1.5>, 0.03 + 0.05*rand(Random) pigment { rgb <0.8, 0.3, 0.2> } }
  #end
  pigment { rgb <0.9, 0.8, 0.6> }
}
