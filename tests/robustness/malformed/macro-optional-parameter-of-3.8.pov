// Optional parameters came with POV-Ray 3.8.
#version 3.7;
#macro Ball(Radius, optional Colour)
  sphere { 0, Radius }
#end
Ball(1)
