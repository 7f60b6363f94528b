#version 3.7;
#declare I = 0;
#while (I < 3)
  #declare A = array[1] { 4 }
  #declare B = A[I];
  #declare I = I + 1;
#end
