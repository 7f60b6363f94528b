#version 3.7;
#declare Size = 11;
#if (Size > 10)
  #error concat("Size ", str(Size, 0, 0), " is too large")
#end
