// Polys keep bounded_by at the top level, and forget its box when a union moves them; sturm on a copy.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1, -9> look_at 0 angle 50 }
light_source { <20, 8, -9> rgb 0.9 }
background { rgb <0.15, 0.2, 0.3> }
#declare Lemniscate = quartic {
  <1,0,0,0,0,0,0,0,0,-1, 0,0,0,0,0,0,0,0,0,0, 0,0,0,0,0,1,0,0,0,0, 0,0,1,0,0>
  bounded_by { sphere { 0, 0.9 } }
  pigment { checker rgb 1 rgb <1, 0.5, 0.3> scale 0.2 } }
object { Lemniscate rotate 30*y translate <-2.5, 1.2, 0> }
object { Lemniscate sturm scale 1.4 rotate <20, 70, 0> translate <0, 1.2, 0> }
union { object { Lemniscate } object { Lemniscate rotate 90*z } scale 1.2 rotate <30, 20, 0> translate <2.5, 1.2, 0> }
intersection { object { Lemniscate scale 1.3 } plane { z, 0.1 } rotate 40*y translate <-2, -1.3, 0> }
quadric { <1, 0, -1>, 0, <0, 1, 0>, -0.3 bounded_by { box { -0.7, 0.7 rotate <30, 40, 0> } } pigment { rgb <0.4, 0.8, 1> } translate <0.3, -1.3, 0> }
quadric { <1, 1, -1>, 0, 0, -0.1 bounded_by { box { -0.7, 0.7 rotate <30, 40, 0> } } pigment { rgb <0.4, 1, 0.6> } rotate 60*y translate <3.1, -1.3, 0> }
