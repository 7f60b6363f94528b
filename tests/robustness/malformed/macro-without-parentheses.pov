#version 3.7;
#macro Ball()
  sphere { 0, 1 }
#end
Ball
sphere { x, 1 }
