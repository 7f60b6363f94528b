// Tilings on boxes whose faces lie along the tiles' common edges, and on the lines where they are folded.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { orthographic location <10, 13, -30> look_at <10, 6.6, 0> right 24*x up 18*y }
#declare Number = 1;
#while (Number <= 24)
  box { 0, 2 pigment { tiling Number color_map { [0 rgb 0] [0.5 rgb <1, 0.5, 0>] [1 rgb 1] } } finish { ambient 1 diffuse 0 }
    rotate <0, 30, 0> translate <4.2 * mod(Number - 1, 6), 3.8 * div(Number - 1, 6), 0> }
  #declare Number = Number + 1;
#end
