// superellipsoids with sharp edges, and stretched: where their zeros are found shows in single pixels.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at 0 }
light_source { <10, 20, -30> rgb 1 }
plane { y, -1.5 pigment { checker rgb 0.8, rgb <0.3, 0.3, 0.5> } }
superellipsoid { <0.1, 0.2> scale <1e-3, 1, 50> rotate 20 pigment { rgb 1 } }
superellipsoid { <0.7169, 0.0558> rotate <185, 169, 160> translate -1.8*x pigment { rgb <0.9, 0.6, 0.3> } finish { phong 0.5 } }
difference {
  superellipsoid { <0.05, 0.18> scale <0.02, 0.8, 0.8> rotate <0, 35, 70> }
  sphere { <0.5, 0.5, -0.5>, 0.6 }
  translate <1.6, 0.2, 0>
  pigment { rgb <0.5, 0.8, 0.5> }
}
superellipsoid { <3, 2.5> scale 0.6 translate <2.5, -0.9, -1> pigment { rgb <0.9, 0.3, 0.3> } }
