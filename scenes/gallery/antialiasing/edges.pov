#version 3.7;
// Edges at every slope between flat colours, thin lines and small dots: what threshold, depth and
// jitter decide on.
global_settings { assumed_gamma 1 }
camera { orthographic location <0.0013, 0.0007, -5> right 4*x up 3*y direction z }
#default { finish { ambient 0 diffuse 0 emission 1 } }
background { rgb <0.05, 0.1, 0.2> }
#for (I, 0, 11)
  cylinder { 0.1*x, 1.1*x, 0.004 + 0.002*I pigment { rgb <1, 0.3 + 0.06*I, 0.2> } rotate z*29.3*I translate -0.6*x }
#end
#for (I, 0, 6)
  box { <0.4, -1.3 + 0.37*I, 0>, <1.8, -1.15 + 0.37*I, 0.1> pigment { rgb <0.2 + 0.1*I, 0.9 - 0.1*I, 0.4> } rotate z*(3*I - 4) }
#end
#for (I, 0, 40)
  sphere { <-1.9 + 0.093*I, 1.3 + 0.1*sin(I), 0>, 0.006 + 0.001*I pigment { rgb <0.9, 0.9, 0.5> } }
#end
