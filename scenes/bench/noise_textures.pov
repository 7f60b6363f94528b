// Spheres and a plane covered with turbulent patterns and bumps: what noise costs.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -8> look_at <0, 0.4, 0> }
light_source { <10, 20, -15> rgb 1 }
#declare Veins = color_map { [0 rgb <0.9, 0.85, 0.8>] [0.5 rgb <0.5, 0.4, 0.35>] [1 rgb <0.1, 0.08, 0.07>] }
plane { y, -0.5 pigment { granite color_map { Veins } scale 0.7 } normal { bumps 0.3 scale 0.1 } }
#for (Index, -3, 3)
  sphere {
    <1.1 * Index, 0, 0>, 0.5
    #switch (mod(Index + 3, 4))
      #case (0) pigment { marble turbulence 0.8 octaves 6 color_map { Veins } scale 0.3 } #break
      #case (1) pigment { wood turbulence 0.2 color_map { Veins } scale 0.2 } normal { wrinkles 0.6 scale 0.2 } #break
      #case (2) pigment { agate color_map { Veins } scale 0.4 } finish { specular 0.5 } #break
      #else pigment { bozo warp { turbulence 0.6 octaves 5 lambda 2 omega 0.6 } color_map { Veins } scale 0.3 }
    #end
  }
#end
