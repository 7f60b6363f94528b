#version 3.7;
#switch (1)
  #else
#end
