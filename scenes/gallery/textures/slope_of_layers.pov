// Slope in layers and entries without a normal of their own sees the normal that was bumped last: that of
// the layer above, or of the entry before.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location -6*z look_at 0 angle 42 }
light_source { <3,5,-6>, 1 }
#declare Bump = texture { pigment { rgbt <1,.7,.5,.7> } normal { bumps .6 scale .2 } }
#declare Bump2 = texture { pigment { rgbt <.5,.7,1,.5> } normal { gradient x .6 scale .3 } }
#declare Slope = texture { pigment { slope <.3,.7,-.5> color_map { [0 rgb <1,0,0>] [.5 rgb <1,1,0>] [1 rgb <0,.5,1>] } } finish { ambient .5 } }
#declare SlopeB = texture { Slope normal { wrinkles .6 scale .3 } }
#declare SlopeN = texture { pigment { rgb 1 } normal { slope <.3,.7,-.5> 1 slope_map { [0 <0,1>] [.5 <1,0>] [1 <0,0>] } } }
#declare SlopeM = texture { pigment { rgb 1 } normal { slope <.3,.7,-.5> normal_map { [0.4 bumps 1 scale .1] [.6 dents 1 scale .1] } } }
#macro S(X,Y) scale .45 rotate <20,30,0> translate <X,Y,0> #end
sphere { 0, 1 texture { Slope } texture { Bump } S(-1.5,1) }
sphere { 0, 1 texture { SlopeB } texture { Bump } S(-.5,1) }
sphere { 0, 1 texture { Slope } texture { Bump } texture { Bump2 } S(.5,1) }
sphere { 0, 1 texture { Slope } texture { Bump } texture { pigment { rgbt <1,1,1,.9> } } S(1.5,1) }
sphere { 0, 1 texture { average texture_map { [1 Bump] [1 Slope] [1 SlopeB] } } S(-1.5,0) }
sphere { 0, 1 texture { checker texture { Bump } texture { Slope } } S(-.5,0) }
box { -.8, .8 texture { Slope } texture { Bump } S(.5,0) }
sphere { 0, 1 texture { gradient y texture_map { [0 Bump] [1 Slope] } } S(1.5,0) }
box { -.8, .8 texture { SlopeN } texture { Bump } S(-0.5, -0.9) }
sphere { 0, 1 texture { SlopeM } texture { Bump } S(0.5, -0.9) }
sphere { 0, 1 texture { average texture_map { [1 Bump] [1 SlopeN] [1 SlopeM] } } S(1.5, -0.9) }
