// Shadow rays pass over what is nearer than 0.001: stickers just above the ground cast no shadow on it, what
// is clear counts once where its sheets lie close, and nothing of it where its first sheet is that near.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0, 4, 0> right 4 * x up 3 * z direction -y sky z }
light_source { <0, 5, 0> rgb 1 }
plane { y, 0 pigment { rgb <1, 0.95, 0.9> } finish { ambient 0 diffuse 1 } }
disc { <-1.2, 0.0005, 0.7>, y, 0.5 pigment { rgb 1 } no_image }
disc { <0, 0.0015, 0.7>, y, 0.5 pigment { rgb 1 } no_image }
box { <0.8, 0.0002, 0.3>, <1.6, 0.0007, 1.1> pigment { rgb 1 } no_image }
mesh {
  triangle { <-1.8, 0.5, -1.2>, <-0.8, 0.5, -1.2>, <-1.3, 0.5, -0.2> }
  triangle { <-1.8, 0.5005, -1.2>, <-0.8, 0.5005, -1.2>, <-1.3, 0.5005, -0.2> }
  triangle { <-1.8, 0.5010, -1.2>, <-0.8, 0.5010, -1.2>, <-1.3, 0.5010, -0.2> }
  pigment { rgbt <1, 0.5, 0.5, 0.5> } no_image
}
mesh {
  triangle { <-0.5, 0.0005, -1.2>, <0.5, 0.0005, -1.2>, <0, 0.0005, -0.2> }
  triangle { <-0.5, 0.5, -1.2>, <0.5, 0.5, -1.2>, <0, 0.5, -0.2> }
  pigment { rgbt <0.5, 1, 0.5, 0.8> } no_image
}
superellipsoid {
  <0.2, 0.2> scale <0.4, 0.2, 0.4> translate <1.3, 0.2005, -0.7>
  pigment { rgbt <0.5, 0.5, 1, 0.6> } no_image
}
