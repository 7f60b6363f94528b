#version 3.7;
#macro Ball(radius)
  sphere { 0, radius }
#end
