// Tilings on faces along the tiles' common edges: z = 0, where some are folded too.
#version 3.7;
global_settings { assumed_gamma 1.0 }
camera { orthographic location <10, 6.6, -30> look_at <10, 6.6, 0> right 26*x up 19.5*y }
#declare Number = 1;
#while (Number <= 24)
  box { <-1.9, -1.7, 0>, <1.9, 1.7, 2> pigment { tiling Number color_map { [0 rgb 0] [0.5 rgb <1, 0.5, 0>] [1 rgb 1] } }
    finish { ambient 1 diffuse 0 } translate <4 * mod(Number - 1, 6), 4 * div(Number - 1, 6), 0> }
  #declare Number = Number + 1;
#end
