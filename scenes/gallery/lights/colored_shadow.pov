// Coloured shadows: filter tints, transmit only dims; two panes multiply, and a plain pane of the
// colour black stops all light.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> right 4/3*x look_at <0, 0.4, 0> angle 45 }

plane { y, 0 pigment { rgb <0.8, 0.78, 0.7> } finish { ambient 0.05 diffuse 0.8 } }

#macro Pane(X, C) box { <X, 0, -0.05>, <X + 0.8, 1.2, 0.05> pigment { C } finish { ambient 0 diffuse 0.3 } } #end
Pane(-2, rgbf <0.9, 0.2, 0.2, 0.9>)
Pane(-1, rgbt <0.2, 0.9, 0.2, 0.7>)
Pane(0, rgbft <0.3, 0.3, 0.9, 0.6, 0.3>)
Pane(1, rgbf <0, 0, 0, 1>)
box { <-2, 0.4, 0.3>, <0.6, 0.8, 0.35> pigment { rgbf <0.8, 0.8, 0.2, 0.7> } finish { ambient 0 } }
light_source { <1, 3, 4> rgb 1 }
light_source { <0, 5, -5> rgb 0.3 shadowless }
