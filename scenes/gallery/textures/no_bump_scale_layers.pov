// no_bump_scale reaches the top layer of a named stack only.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location <0,0,-5> look_at 0 right x*8 up y*6 }
light_source { <-50, 80, -100> rgb 0.9 }
#declare N1 = texture { pigment { rgb 1 } normal { bumps 0.3 scale 0.5 } }
#declare N2 = texture { pigment { rgbt <1,1,1,0.99> } normal { bumps 0.3 scale 0.5 } finish { phong 1 } }
#declare L = texture { N1 } texture { N2 }
#macro S(X,Y) sphere { 0,0.95 translate <-3+X*2,2-Y*2,0> #end
S(0,0) texture { N1 scale 0.3 } }
S(1,0) texture { N1 no_bump_scale scale 0.3 } }
S(2,0) texture { L scale 0.3 } }
S(3,0) texture { L no_bump_scale scale 0.3 } }
S(0,1) texture { N1 no_bump_scale scale 0.3 } texture { N2 no_bump_scale scale 0.3 } }
S(1,1) texture { N1 no_bump_scale scale 0.3 } texture { N2 scale 0.3 } }
S(2,1) texture { N1 scale 0.3 } texture { N2 no_bump_scale scale 0.3 } }
#declare LL = texture { L no_bump_scale }
S(3,1) texture { LL scale 0.3 } }
S(0,2) texture { gradient x texture_map { [0.5 N1][0.5 N1 scale 2] } scale 0.5 } }
S(1,2) texture { gradient x texture_map { [0.5 N1][0.5 N1 scale 2] } scale 0.5 no_bump_scale } }
S(2,2) texture { gradient x texture_map { [0.5 N1][0.5 N1 scale 2] } no_bump_scale scale 0.5 } }
#declare G = texture { gradient x texture_map { [0.5 N1][0.5 N1 scale 2] } }
S(3,2) texture { G no_bump_scale scale 0.5 } }
