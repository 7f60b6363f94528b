#version 3.7;
#macro Ball(Centre, Radius)
  sphere { Centre, Radius }
#end
Ball(x, 1, 2)
