// A directive where the operator after an operand is looked for.
#version 3.7;
#macro Factorial(N)
  #if (N < 2)
    1
  #else
    (N * Factorial(N - 1))
  #end
#end
#if (Factorial(4) > 10)
#end
