// 300,000 turns of a #while loop that computes with arrays and vectors: what one expression costs.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0, -4> look_at 0 }
light_source { <3, 5, -4> rgb 1 }

#declare Size = 64;
#declare Heights = array[Size];
#declare Points = array[Size];
#declare Turn = 0;
#while (Turn < Size)
  #declare Heights[Turn] = sin(Turn);
  #declare Points[Turn] = <Turn, 0, -Turn>;
  #declare Turn = Turn + 1;
#end

#declare Turn = 0;
#while (Turn < 300000)
  #declare Here = mod(Turn, Size);
  #declare Next = mod(Turn + 7, Size);
  #declare Heights[Here] = 0.5 * Heights[Here] + 0.25 * sin(Heights[Next] + Turn * 0.001);
  #declare Points[Here] = vnormalize(Points[Next] + <Heights[Here], 1, 0.5>) * 3 - Points[Here].y * x;
  #if (vdot(Points[Here], y) > 2.5 & Turn > 100)
    #declare Points[Here] = vcross(Points[Here], z) + <0, Heights[Next], 0>;
  #end
  #declare Turn = Turn + 1;
#end

#declare Sum = 0;
#for (Index, 0, Size - 1)
  #declare Sum = Sum + Heights[Index] + vlength(Points[Index]);
#end
#debug concat("sum ", str(Sum, 0, 6), "\n")
sphere { 0, 1 pigment { rgb <1, mod(Sum, 1), 0.2> } }
