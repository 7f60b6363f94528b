#version 3.7;
#macro Ball(Radius)
  sphere { 0, Radius }
#end
Ball(Radious)
