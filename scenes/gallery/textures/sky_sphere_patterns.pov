// sky_sphere: patterns see the unit direction; slope and aoi are 0 there; values below 0 wrap.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location 0 look_at z angle 120 }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.6, 0.3, 0.1>] [0.5 rgb <0.9, 0.9, 0.7>] [1 rgb <0.1, 0.2, 0.5>] } }
  pigment { checker rgbt <1, 1, 1, 1>, rgbt <1, 0, 0, 0.6> scale 0.2 translate 0.013 }
  pigment { slope y color_map { [0 rgbt <0.5, 1, 0.5, 0.8>] [0.5 rgb x] } }
}
