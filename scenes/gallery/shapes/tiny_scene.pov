// A whole scene of some hundred-thousandths of a unit: below the least depth of hits, of which some
// are lost.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Size = 1e-5;
camera { location <0, 1.5, -9>*Size look_at <0, -0.1, 0>*Size angle 48 }
light_source { <-6, 8, -10>*Size, 1 }
light_source { <7, 2, -6>*Size, rgb 0.35 shadowless }
background { rgb <0.1, 0.15, 0.25> }
#default { pigment { rgb <0.9, 0.65, 0.3> } finish { ambient 0.1 diffuse 0.7 phong 0.6 phong_size 30 } }
#declare Squares = texture { pigment { checker rgb <1, 0.95, 0.8>, rgb <0.2, 0.4, 0.8> scale 0.125 } }
union {
  sphere { <-2, 1, 0>, 0.9 texture { Squares } }
  box { <-0.7, 0.3, -0.7>, <0.7, 1.7, 0.7> rotate 30*y }
  torus { 0.7, 0.25 rotate 60*x translate <2, 1, 0> }
  cone { <-2, -1.9, 0>, 0.9, <-2, -0.4, 0>, 0.3 pigment { rgb <0.4, 0.8, 0.4> } }
  difference { cylinder { <0, -1.9, 0>, <0, -0.5, 0>, 0.8 } sphere { <0.3, -0.7, -0.7>, 0.6 pigment { rgb <0.8, 0.2, 0.2> } } }
  mesh { triangle { <1.2, -1.9, 0>, <2.8, -1.8, 0.3>, <2, -0.4, -0.2> } triangle { <2.8, -1.8, 0.3>, <2, -0.4, -0.2>, <3, -0.3, 0.4> } pigment { rgb <0.6, 0.6, 0.9> } }
  box { <-5, -2.2, -3>, <5, -2, 4> pigment { checker rgb 1, rgb 0.5 } }
  scale Size
}
