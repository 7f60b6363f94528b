#version 3.7;
#switch (1)
  sphere { 0, 1 }
  #case (1)
#end
