#version 3.7;
#if (0)
#else
  sphere { 0, 1 }
#else
#end
